/* SPDX-License-Identifier: Apache-2.0 */
/* toolcomp for C, and for languages that can call C: the fast engine, for blocks of text or for arrays.
 *
 * Lengths are in the units of the setup (mm or inch), angles in degrees. A number that the control does not have is
 * NaN. One thread at a time may use a handle; different threads may use different handles. No function prints, throws,
 * exits or changes the locale. A text that a function returns lives as long as the handle that it was called with. The
 * texts of an event live until the callback returns.
 *
 * The exact model is in the command, the C++ library and the Python package. docs/c.md has examples of both ways.
 */
#ifndef TOOLCOMP_H
#define TOOLCOMP_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The version of this header. toolcomp_version() gives the version of the library. */
#define TOOLCOMP_VERSION_MAJOR 1
#define TOOLCOMP_VERSION_MINOR 0
#define TOOLCOMP_VERSION_PATCH 0
/* "1.0.0" */
const char* toolcomp_version(void);

/* The result of a call. If it is not TOOLCOMP_OK, the error says why. A call that failed has changed nothing, with one
 * exception: of a text, the blocks before the fault have been run. */
typedef enum toolcomp_status {
  TOOLCOMP_OK = 0,
  TOOLCOMP_BAD_INPUT = 1, /* a setup, a program or a file that cannot be read; the error has line and column */
  TOOLCOMP_BAD_CALL = 2,  /* bad arguments: columns of different lengths, a word that the control does not have */
  TOOLCOMP_NO_MEMORY = 3,
  TOOLCOMP_FAILED = 4 /* an internal check failed: please report it */
} toolcomp_status;

/* Why a call failed. Every call that can fail takes a pointer to it; the pointer may be NULL. */
typedef struct toolcomp_error {
  uint64_t line; /* from 1; 0 if there is none */
  uint64_t column;
  char message[512]; /* ends in 0; a longer message is cut off */
} toolcomp_error;

/* --- setups ----------------------------------------------------------------------------------------------------- */

/* The setup of a control: axes, parameters, offsets, tools. `toolcomp config example` prints one with comments. */
typedef struct toolcomp_setup toolcomp_setup;

/* Reads a TOML or JSON text. JSON begins with a brace. */
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

/* One event of a run (docs/events.md). New versions add fields only at the end. `size` is the number of bytes that the
 * library fills. */
typedef struct toolcomp_event {
  size_t size;
  toolcomp_event_kind kind;
  uint64_t line; /* line of the text, from 1 */
  uint64_t n;    /* sequence number; TOOLCOMP_NO_NUMBER if there is none */

  /* Moves have these fields. Samples have point, axes, tool_axis and t. */
  toolcomp_move_type type;
  toolcomp_cause cause;
  double programmed[TOOLCOMP_MOST_AXES]; /* the programmed end point, absolute, in workpiece coordinates */
  double point[TOOLCOMP_MOST_AXES];      /* the compensated tool point, before length offset */
  double axes[TOOLCOMP_MOST_AXES];       /* positions that the axes are sent to, in workpiece coordinates */
  double machine[TOOLCOMP_MOST_AXES];    /* the same in machine coordinates, if the event has them */
  double tool_axis[3];                   /* unit vector from tip to holder */
  double feed;
  uint32_t t_numerator, t_denominator; /* samples: the fraction of the block */

  /* arcs */
  double center[TOOLCOMP_MOST_AXES];
  toolcomp_plane plane;
  toolcomp_direction direction;
  double sweep;     /* degrees of the arc that the tool runs; NaN if an end is in the centre */
  double radius[2]; /* at the start and at the end, if they differ; otherwise NaN */

  /* number: of an alarm or a warning, such as "PS0041"; of an undecided event, the clause; of a not supported or not
   * judged event, the word of the program, such as "G81"; of a setting, its name, such as "H1", with its value.
   * Otherwise "". */
  const char* number;
  const char* message;
  double value;

  /* Heidenhain blocks with 3D tool compensation; X, Y, Z */
  double tool_center[3]; /* centre of the effective tool */
  double shift[3];       /* tip of the effective tool less tip of the nominal tool */
  double tool_shift[3];  /* shift of the real tool against a tool without deltas */
  double contact[3];     /* the point at which the cutter touches the workpiece */
  double normal[3];      /* the surface normal at that point */

  const char* alarm; /* of an alarm: its cause, such as "interference", the same for all series; otherwise "" */

  /* Holes have these coordinates along the drilling axis. They also have point (the linear axes without the drilling
   * axis) and axes (the positions after the hole). */
  double point_r;
  double bottom;
  double level; /* the level to which the tool returns */
} toolcomp_event;

/* Called for each event, in order. It must not call the engine that called it, and must not leave by longjmp. */
typedef void (*toolcomp_on_event)(void* user, const toolcomp_event* event);

/* --- blocks as text --------------------------------------------------------------------------------------------- */

/* One run of one program. */
typedef struct toolcomp_engine toolcomp_engine;

/* `samples`: the number of parts into which each block under tool center point control is divided; 0 gives no samples.
 * The setup may be freed after this call. */
toolcomp_status toolcomp_engine_new(const toolcomp_setup* setup, uint32_t samples, toolcomp_on_event on_event,
                                    void* user, toolcomp_engine** engine, toolcomp_error* error);
/* Runs blocks as the program has them: any number of whole lines. A Klartext program with labels or called programs
 * must be given in one call. After the end of the run, or of the program, further blocks are ignored. */
toolcomp_status toolcomp_engine_run(toolcomp_engine* engine, const char* text, size_t length, toolcomp_error* error);
/* Ends the text: the engine gives the blocks that it held back for the look-ahead. */
toolcomp_status toolcomp_engine_end(toolcomp_engine* engine, toolcomp_error* error);
/* 1 after an alarm, after a word that is not supported or not judged, and after the end of the program; otherwise 0. */
int toolcomp_engine_stopped(const toolcomp_engine* engine);
void toolcomp_engine_free(toolcomp_engine* engine);

/* --- blocks as arrays ------------------------------------------------------------------------------------------- */

/* Compensation of millions of lines: from columns of words to columns of axis positions. The moves are bit for bit
 * those of the engine on the same blocks. */
typedef struct toolcomp_batch toolcomp_batch;

/* One word of many blocks: "X", "I", "F"; for vectors of Klartext "NX" … "TZ". The word is the decimal nearest to the
 * value with this number of places, as a post processor prints it. */
typedef struct toolcomp_column {
  const char* word;
  const double* values;
  unsigned decimals; /* at most 9; 3 is usual */
} toolcomp_column;

/* The moves, in order. Valid until the next call for this batch. */
typedef struct toolcomp_moves {
  size_t count;
  size_t axes;
  const double* axis[TOOLCOMP_MOST_AXES]; /* the position the axis is sent to; NaN if the move does not name it */
  const uint64_t* block;                  /* the block that a move belongs to, from 1 */
} toolcomp_moves;

/* `on_event` gets the events other than moves: alarms, warnings, settings. It may be NULL. */
toolcomp_status toolcomp_batch_new(const toolcomp_setup* setup, toolcomp_on_event on_event, void* user,
                                   toolcomp_batch** batch, toolcomp_error* error);
/* Runs blocks given as text: modes, offsets, start-up and cancel. */
toolcomp_status toolcomp_batch_run(toolcomp_batch* batch, const char* text, size_t length, toolcomp_error* error);
/* Runs `blocks` blocks. Each block has all the words of the columns, and the modes in force. */
toolcomp_status toolcomp_batch_lines(toolcomp_batch* batch, const toolcomp_column* columns, size_t column_count,
                                     size_t blocks, toolcomp_error* error);
toolcomp_status toolcomp_batch_end(toolcomp_batch* batch, toolcomp_error* error);
int toolcomp_batch_stopped(const toolcomp_batch* batch);
/* The moves so far, or since toolcomp_batch_clear_moves. */
toolcomp_moves toolcomp_batch_moves(const toolcomp_batch* batch);
void toolcomp_batch_clear_moves(toolcomp_batch* batch);
void toolcomp_batch_free(toolcomp_batch* batch);

#ifdef __cplusplus
}
#endif

#endif
