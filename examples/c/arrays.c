/* A polygon with a million corners, compensated: words in, axis positions out. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <toolcomp.h>

static const char kSetup[] =
    "control = \"fanuc\"\n"
    "axes = [\"X\", \"Y\", \"Z\"]\n"
    "cutter_compensation = \"C\"\n"
    "[offsets.D]\n"
    "1 = 5\n";
static const char kBefore[] = "G90 G01 F1000 X200 Y0\nG41 D1 X100\n";

static void check(toolcomp_status status, const toolcomp_error* error) {
  if (status == TOOLCOMP_OK) return;
  fprintf(stderr, "%s\n", error->message);
  exit(1);
}

int main(void) {
  const size_t blocks = 1000000;
  const double turn = 6.283185307179586 / (double)blocks;
  toolcomp_setup* setup = NULL;
  toolcomp_batch* batch = NULL;
  toolcomp_error error;
  toolcomp_moves moves;
  toolcomp_column columns[2];
  double farthest = 0;
  double* x = malloc(blocks * sizeof *x);
  double* y = malloc(blocks * sizeof *y);
  size_t i;
  if (x == NULL || y == NULL) return 1;
  /* Counterclockwise about the origin, radius 100: the tool, on the left, runs inside. */
  for (i = 0; i < blocks; ++i) {
    x[i] = 100 * cos((double)(i + 1) * turn);
    y[i] = 100 * sin((double)(i + 1) * turn);
  }
  check(toolcomp_setup_from_text(kSetup, strlen(kSetup), &setup, &error), &error);
  check(toolcomp_batch_new(setup, NULL, NULL, &batch, &error), &error);
  check(toolcomp_batch_run(batch, kBefore, strlen(kBefore), &error), &error);
  columns[0].word = "X";
  columns[0].values = x;
  columns[0].decimals = 9;
  columns[1].word = "Y";
  columns[1].values = y;
  columns[1].decimals = 9;
  check(toolcomp_batch_lines(batch, columns, 2, blocks, &error), &error);
  moves = toolcomp_batch_moves(batch);
  for (i = 2; i < moves.count; ++i) {
    const double off = fabs(hypot(moves.axis[0][i], moves.axis[1][i]) - 95);
    if (off > farthest) farthest = off;
  }
  printf("%lu moves, at most %.0e mm from the circle of radius 95\n", (unsigned long)moves.count, farthest);
  toolcomp_batch_free(batch);
  toolcomp_setup_free(setup);
  free(x);
  free(y);
  return farthest < 1e-6 && moves.count >= blocks ? 0 : 1;
}
