/* SPDX-License-Identifier: Apache-2.0 */
/* Runs the starter vectors against your function. C99, nothing but the standard library:
 *
 *     cc -std=c99 run.c -lm -o run && ./run
 *     cc -std=c99 -DCONTROLLER='"mine.c"' run.c -lm -o run && ./run
 *
 * The file of the controller defines `sections` and `needs`, which name what it knows, and `your_function`, which fills
 * in where the axes go at the end of each move, in the order of vector->axes, and the alarm if one ends the program.
 * Exit status: 0 all agree, 1 one does not, or nothing was compared. */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../../starter.h"

#define MOST_POINTS 64

struct answer {
  double points[MOST_POINTS][TOOLCOMP_STARTER_AXES];
  int count;
  int alarm_line; /* 0: no alarm */
  char alarm[32]; /* its number, or its cause as in starter.json */
};

#ifndef CONTROLLER
#define CONTROLLER "example.c"
#endif
#include CONTROLLER

static int knows(const char* const* names, const char* name, size_t length) {
  for (; *names; ++names) {
    if (strlen(*names) == length && strncmp(*names, name, length) == 0) return 1;
  }
  return 0;
}

static int knows_all(const char* wanted) {
  while (*wanted) {
    size_t length = strcspn(wanted, " ");
    if (!knows(needs, wanted, length)) return 0;
    wanted += length + (wanted[length] == ' ');
  }
  return 1;
}

static void show(const char* axes, const double* point) {
  int axis;
  if (!point) printf(" nothing");
  for (axis = 0; point && axes[axis]; ++axis) printf(" %c%.10g", axes[axis], point[axis]);
}

/* Written so that a NaN, which compares with nothing, does not agree. */
static int agrees(const char* axes, const double* want, const double* got, double tolerance) {
  int axis;
  for (axis = 0; axes[axis]; ++axis) {
    if (!(fabs(got[axis] - want[axis]) <= tolerance)) return 0;
  }
  return 1;
}

/* Prints the first thing that is not as expected, and says whether there is one. */
static int differs(const struct toolcomp_starter_vector* v, const struct answer* a) {
  int i;
  for (i = 0; i < v->point_count || i < a->count; ++i) {
    const double* want = i < v->point_count ? v->points[i].axes : NULL;
    const double* got = i < a->count ? a->points[i] : NULL;
    if (want && got && agrees(v->axes, want, got, v->tolerance)) continue;
    printf("FAILED %s: %s\n  mistake: %s\n  point %d", v->name, v->shows, v->catches, i + 1);
    if (want) printf(", line %d", v->points[i].line);
    printf(": expected");
    show(v->axes, want);
    printf(", got");
    show(v->axes, got);
    printf("\n  see pictures/%s.svg\n", v->name);
    return 1;
  }
  if (v->alarm_line == a->alarm_line &&
      (!v->alarm_line || !strcmp(a->alarm, v->alarm_number) || !strcmp(a->alarm, v->alarm_cause))) {
    return 0;
  }
  printf("FAILED %s: %s\n  mistake: %s\n  alarm: expected line %d %s (%s), got line %d %s; line 0: none\n", v->name,
         v->shows, v->catches, v->alarm_line, v->alarm_number, v->alarm_cause, a->alarm_line, a->alarm);
  return 1;
}

int main(void) {
  int i, agreed = 0, failed = 0;
  for (i = 0; i < TOOLCOMP_STARTER_COUNT; ++i) {
    const struct toolcomp_starter_vector* v = &toolcomp_starter_vectors[i];
    static struct answer answer;
    if (!knows(sections, v->section, strlen(v->section)) || !knows_all(v->needs)) continue;
    memset(&answer, 0, sizeof answer);
    your_function(v, &answer);
    if (differs(v, &answer)) {
      ++failed;
    } else {
      ++agreed;
    }
  }
  printf("%d vectors agree, %d do not, %d skipped: their section or a need is not named\n", agreed, failed,
         TOOLCOMP_STARTER_COUNT - agreed - failed);
  return agreed && !failed ? 0 : 1;
}
