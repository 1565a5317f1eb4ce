/* SPDX-License-Identifier: Apache-2.0 */
/* toolcomp for C, and for whatever calls C: the fast engine, a block at a time or by arrays.
 *
 * Lengths are in the units of the setup (mm or inch), angles in degrees. What a control has no number for is NaN.
 * A handle is used by one thread at a time; different handles by as many as you like. No function prints, throws,
 * exits or changes the locale. Texts that are returned live as long as the handle they were asked of, those of an event
 * until its function returns.
 *
 * The exact model is behind the command, the C++ library and the Python package. docs/c.md shows both ways at work.
 */
#ifndef TOOLCOMP_H
#define TOOLCOMP_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Of this header; the library's own: toolcomp_version(). */
#define TOOLCOMP_VERSION_MAJOR 0
#define TOOLCOMP_VERSION_MINOR 1
#define TOOLCOMP_VERSION_PATCH 0
/* "0.1.0" */
const char* toolcomp_version(void);

/* What a call came to; where it is not TOOLCOMP_OK the error says why. A call that failed has done nothing, but for
 * text of which the blocks before the fault have been run. */
typedef enum toolcomp_status {
  TOOLCOMP_OK = 0,
  TOOLCOMP_BAD_INPUT = 1, /* a setup, a program or a file that cannot be read: at a line and a column */
  TOOLCOMP_BAD_CALL = 2,  /* arguments that make no sense: columns of different lengths, a word the control has not */
  TOOLCOMP_NO_MEMORY = 3,
  TOOLCOMP_FAILED = 4 /* an internal check did: please report it */
} toolcomp_status;

/* Why a call failed. Given to every call that can; NULL where nobody wants to know. */
typedef struct toolcomp_error {
  uint64_t line; /* from 1; 0: none */
  uint64_t column;
  char message[512]; /* ends in 0; cut off where longer */
} toolcomp_error;

/* --- setups ----------------------------------------------------------------------------------------------------- */

/* What a control is: axes, parameters, offsets, tools (`toolcomp config example` prints one with comments). */
typedef struct toolcomp_setup toolcomp_setup;

/* A TOML or JSON text (JSON begins with a brace). */
toolcomp_status toolcomp_setup_from_text(const char* text, size_t length, toolcomp_setup** setup,
                                         toolcomp_error* error);
toolcomp_status toolcomp_setup_from_file(const char* path, toolcomp_setup** setup, toolcomp_error* error);
/* The letters of the controlled axes in their order: "XYZBC". Arrays of axes below are in this order. */
const char* toolcomp_setup_axes(const toolcomp_setup* setup);
void toolcomp_setup_free(toolcomp_setup* setup);

/* --- events ----------------------------------------------------------------------------------------------------- */

enum { TOOLCOMP_MOST_AXES = 9 };

typedef enum toolcomp_event_kind {
  TOOLCOMP_MOVE = 0,
  TOOLCOMP_SAMPLE = 1,
  TOOLCOMP_ALARM = 2,
  TOOLCOMP_WARNING = 3,
  TOOLCOMP_SETTING = 4,
  TOOLCOMP_UNDECIDED = 5,
  TOOLCOMP_NOT_SUPPORTED = 6,
  TOOLCOMP_NOT_JUDGED = 7,
  TOOLCOMP_HOLE = 8
} toolcomp_event_kind;
typedef enum toolcomp_move_type { TOOLCOMP_RAPID = 0, TOOLCOMP_LINEAR = 1, TOOLCOMP_ARC = 2 } toolcomp_move_type;
typedef enum toolcomp_cause {
  TOOLCOMP_PROGRAMMED = 0,
  TOOLCOMP_START_UP = 1,
  TOOLCOMP_CORNER = 2,
  TOOLCOMP_CANCEL = 3,
  TOOLCOMP_PRE_TURN = 4,
  TOOLCOMP_POST_TURN = 5,
  TOOLCOMP_REFERENCE = 6,
  TOOLCOMP_MEASURE = 7
} toolcomp_cause;
typedef enum toolcomp_plane { TOOLCOMP_XY = 0, TOOLCOMP_ZX = 1, TOOLCOMP_YZ = 2 } toolcomp_plane;
typedef enum toolcomp_direction { TOOLCOMP_CW = 0, TOOLCOMP_CCW = 1 } toolcomp_direction;

#define TOOLCOMP_NO_NUMBER UINT64_MAX

/* What a run yields (docs/events.md). Fields are only ever added at the end: `size` says how many bytes the library
 * fills. */
typedef struct toolcomp_event {
  size_t size;
  toolcomp_event_kind kind;
  uint64_t line; /* of the text, from 1 */
  uint64_t n;    /* sequence number; TOOLCOMP_NO_NUMBER: none */

  /* moves; samples have point, axes, tool_axis and t */
  toolcomp_move_type type;
  toolcomp_cause cause;
  double programmed[TOOLCOMP_MOST_AXES]; /* the programmed end, absolute, workpiece coordinates */
  double point[TOOLCOMP_MOST_AXES];      /* the compensated tool point, before length offset */
  double axes[TOOLCOMP_MOST_AXES];       /* what the axes are sent to, workpiece coordinates */
  double machine[TOOLCOMP_MOST_AXES];    /* machine coordinates, where an event has them */
  double tool_axis[3];                   /* tip to holder, unit */
  double feed;
  uint32_t t_numerator, t_denominator; /* samples: where in their block */

  /* arcs */
  double center[TOOLCOMP_MOST_AXES];
  toolcomp_plane plane;
  toolcomp_direction direction;
  double sweep;     /* degrees of the tool's own arc; NaN: an end lies in the centre */
  double radius[2]; /* at start and end, where they differ; else NaN */

  /* alarms, warnings: "PS0041"; undecided: a clause; not supported, not judged: "G81"; settings: "H1" and its value.
   * Else "". */
  const char* number;
  const char* message;
  double value;

  /* Heidenhain blocks with 3D tool compensation; X, Y, Z */
  double tool_center[3]; /* of the effective tool */
  double shift[3];       /* of the tip against the nominal tool */
  double tool_shift[3];  /* of the real tool against one without deltas */
  double contact[3];     /* where the cutter touches, and the surface normal there */
  double normal[3];

  const char* alarm; /* alarms: the cause, the same for all series: "interference"; else "" */

  /* holes, which also have point (the linear axes but the drilling axis) and axes (behind the hole): coordinates along
   * the drilling axis */
  double point_r;
  double bottom;
  double level; /* to which the tool returns */
} toolcomp_event;

/* Called for each event, in order. It must not call the engine it was called by, nor leave by longjmp. */
typedef void (*toolcomp_on_event)(void* user, const toolcomp_event* event);

/* --- a block at a time ------------------------------------------------------------------------------------------ */

/* One run of one program. */
typedef struct toolcomp_engine toolcomp_engine;

/* `samples`: into how many parts each block under tool center point control is divided; 0: no samples. The setup may be
 * freed at once. */
toolcomp_status toolcomp_engine_new(const toolcomp_setup* setup, uint32_t samples, toolcomp_on_event on_event,
                                    void* user, toolcomp_engine** engine, toolcomp_error* error);
/* Blocks as the program has them: whole lines, as many as you like; a Klartext program with labels or called programs
 * at once. After what ends the run, or the end of the program, what comes is ignored. */
toolcomp_status toolcomp_engine_run(toolcomp_engine* engine, const char* text, size_t length, toolcomp_error* error);
/* The end of the text: blocks that waited for the next one go out. */
toolcomp_status toolcomp_engine_end(toolcomp_engine* engine, toolcomp_error* error);
/* 1: an alarm, what is not supported or not judged, or the end of the program has been reached. */
int toolcomp_engine_stopped(const toolcomp_engine* engine);
void toolcomp_engine_free(toolcomp_engine* engine);

/* --- by arrays -------------------------------------------------------------------------------------------------- */

/* Lines by the million: columns of words in, columns of axis positions out. The moves are those of the engine on the
 * same blocks, bit for bit. */
typedef struct toolcomp_batch toolcomp_batch;

/* One word of many blocks: "X", "I", "F"; Klartext vectors "NX" … "TZ". Each is the decimal of so many places that is
 * nearest to the value, as a post processor prints it. */
typedef struct toolcomp_column {
  const char* word;
  const double* values;
  unsigned decimals; /* at most 9; 3 is usual */
} toolcomp_column;

/* Moves, from the first. Valid until the next call for this batch. */
typedef struct toolcomp_moves {
  size_t count;
  size_t axes;
  const double* axis[TOOLCOMP_MOST_AXES]; /* what it is sent to; NaN: the move does not name it */
  const uint64_t* block;                  /* the block a move belongs to, from 1 */
} toolcomp_moves;

/* `on_event`: gets what is no move (alarms, warnings, settings); may be NULL. */
toolcomp_status toolcomp_batch_new(const toolcomp_setup* setup, toolcomp_on_event on_event, void* user,
                                   toolcomp_batch** batch, toolcomp_error* error);
/* Blocks as text: modes, offsets, start-up and cancel. */
toolcomp_status toolcomp_batch_run(toolcomp_batch* batch, const char* text, size_t length, toolcomp_error* error);
/* `blocks` blocks, each of all the words, under the modes in force. */
toolcomp_status toolcomp_batch_lines(toolcomp_batch* batch, const toolcomp_column* columns, size_t column_count,
                                     size_t blocks, toolcomp_error* error);
toolcomp_status toolcomp_batch_end(toolcomp_batch* batch, toolcomp_error* error);
int toolcomp_batch_stopped(const toolcomp_batch* batch);
/* So far, or since they were cleared. */
toolcomp_moves toolcomp_batch_moves(const toolcomp_batch* batch);
void toolcomp_batch_clear_moves(toolcomp_batch* batch);
void toolcomp_batch_free(toolcomp_batch* batch);

#ifdef __cplusplus
}
#endif

#endif
