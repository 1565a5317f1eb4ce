// The toolcomp command: verbs only.
int main() {}
