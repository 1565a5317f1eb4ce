# Installed: the command and the libraries of the specification and both engines (find_package(toolcomp)).
