/* Runs a program through the fast engine, a part at a time, and prints where the axes are sent.
 *
 *     run SETUP.toml PROGRAM.nc
 */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <toolcomp.h>

/* What the function below needs to know. */
struct printing {
  const char* axes; /* their letters */
  int alarms;
};

static void print(void* user, const toolcomp_event* event) {
  struct printing* printing = user;
  size_t i;
  if (event->kind == TOOLCOMP_ALARM) {
    printf("line %lu: alarm %s, %s\n", (unsigned long)event->line, event->number, event->message);
    ++printing->alarms;
  }
  if (event->kind != TOOLCOMP_MOVE) return;
  printf("line %lu:", (unsigned long)event->line);
  for (i = 0; printing->axes[i] != '\0'; ++i)
    if (!isnan(event->axes[i])) printf(" %c%.6g", printing->axes[i], event->axes[i]);
  printf("%s\n", event->cause == TOOLCOMP_CORNER ? " (corner)" : "");
}

static int failed(const char* what, const toolcomp_error* error) {
  fprintf(stderr, "%s:%lu:%lu: %s\n", what, (unsigned long)error->line, (unsigned long)error->column, error->message);
  return 2;
}

int main(int argc, char** argv) {
  struct printing printing = {0, 0};
  toolcomp_setup* setup = NULL;
  toolcomp_engine* engine = NULL;
  toolcomp_error error;
  char block[1024];
  FILE* program;
  int status = 0;
  if (argc != 3) {
    fprintf(stderr, "usage: run SETUP.toml PROGRAM.nc\n");
    return 2;
  }
  if (toolcomp_setup_from_file(argv[1], &setup, &error) != TOOLCOMP_OK) return failed(argv[1], &error);
  program = fopen(argv[2], "r");
  if (program == NULL) {
    perror(argv[2]);
    toolcomp_setup_free(setup);
    return 2;
  }
  printing.axes = toolcomp_setup_axes(setup);
  if (toolcomp_engine_new(setup, 0, print, &printing, &engine, &error) != TOOLCOMP_OK) status = failed(argv[1], &error);
  while (status == 0 && !toolcomp_engine_stopped(engine) && fgets(block, sizeof block, program) != NULL)
    if (toolcomp_engine_run(engine, block, strlen(block), &error) != TOOLCOMP_OK) status = failed(argv[2], &error);
  if (status == 0 && toolcomp_engine_end(engine, &error) != TOOLCOMP_OK) status = failed(argv[2], &error);
  if (status == 0 && printing.alarms > 0) status = 1;
  fclose(program);
  toolcomp_engine_free(engine);
  toolcomp_setup_free(setup);
  return status;
}
