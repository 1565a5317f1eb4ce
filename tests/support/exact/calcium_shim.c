// SPDX-License-Identifier: Apache-2.0
#include "tests/support/exact/calcium_shim.h"

#include <calcium/ca.h>
#include <stdlib.h>

/* Exported by the library though not declared in its header. ca_check_is_zero goes on to factor polynomials, which for
   sines of decimal degrees can take minutes and has not decided any more of them. */
truth_t ca_check_is_zero_no_factoring(const ca_t x, ca_ctx_t context);

struct calcium_machine {
  ca_ctx_t context;
  ca_ptr numbers;
  int slots;
};

calcium_machine* calcium_new(int slots) {
  calcium_machine* machine = malloc(sizeof *machine);
  if (machine == NULL) abort();
  ca_ctx_init(machine->context);
  /* Bounds that keep one question in the range of milliseconds; beyond them Calcium says "unknown". */
  machine->context->options[CA_OPT_PREC_LIMIT] = 256;
  machine->context->options[CA_OPT_QQBAR_DEG_LIMIT] = 12;
  machine->context->options[CA_OPT_GROEBNER_LENGTH_LIMIT] = 10;
  machine->context->options[CA_OPT_GROEBNER_POLY_LENGTH_LIMIT] = 200;
  machine->numbers = flint_malloc((size_t)slots * sizeof *machine->numbers);
  machine->slots = slots;
  for (int i = 0; i < slots; ++i) ca_init(machine->numbers + i, machine->context);
  return machine;
}

void calcium_delete(calcium_machine* machine) {
  for (int i = 0; i < machine->slots; ++i) ca_clear(machine->numbers + i, machine->context);
  flint_free(machine->numbers);
  ca_ctx_clear(machine->context);
  free(machine);
}

void calcium_rational(calcium_machine* machine, int to, const char* value) {
  fmpq_t rational;
  fmpq_init(rational);
  if (fmpq_set_str(rational, value, 10) != 0) abort();
  ca_set_fmpq(machine->numbers + to, rational, machine->context);
  fmpq_clear(rational);
}

static void sine_or_cosine(calcium_machine* machine, int to, const char* degrees,
                           void (*function)(ca_t, const ca_t, ca_ctx_t)) {
  ca_t radians;
  ca_init(radians, machine->context);
  calcium_rational(machine, to, degrees);
  ca_pi(radians, machine->context);
  ca_mul(radians, radians, machine->numbers + to, machine->context);
  ca_div_ui(radians, radians, 180, machine->context);
  function(machine->numbers + to, radians, machine->context);
  ca_clear(radians, machine->context);
}

void calcium_sine_of_degrees(calcium_machine* machine, int to, const char* degrees) {
  sine_or_cosine(machine, to, degrees, ca_sin);
}

void calcium_cosine_of_degrees(calcium_machine* machine, int to, const char* degrees) {
  sine_or_cosine(machine, to, degrees, ca_cos);
}

void calcium_pi(calcium_machine* machine, int to) { ca_pi(machine->numbers + to, machine->context); }

void calcium_arctangent_degrees(calcium_machine* machine, int to, int a) {
  ca_t pi;
  ca_init(pi, machine->context);
  ca_pi(pi, machine->context);
  ca_atan(machine->numbers + to, machine->numbers + a, machine->context);
  ca_mul_ui(machine->numbers + to, machine->numbers + to, 180, machine->context);
  ca_div(machine->numbers + to, machine->numbers + to, pi, machine->context);
  ca_clear(pi, machine->context);
}

void calcium_negate(calcium_machine* machine, int to, int a) {
  ca_neg(machine->numbers + to, machine->numbers + a, machine->context);
}

void calcium_add(calcium_machine* machine, int to, int a, int b) {
  ca_add(machine->numbers + to, machine->numbers + a, machine->numbers + b, machine->context);
}

void calcium_subtract(calcium_machine* machine, int to, int a, int b) {
  ca_sub(machine->numbers + to, machine->numbers + a, machine->numbers + b, machine->context);
}

void calcium_multiply(calcium_machine* machine, int to, int a, int b) {
  ca_mul(machine->numbers + to, machine->numbers + a, machine->numbers + b, machine->context);
}

void calcium_divide(calcium_machine* machine, int to, int a, int b) {
  ca_div(machine->numbers + to, machine->numbers + a, machine->numbers + b, machine->context);
}

void calcium_root(calcium_machine* machine, int to, int a) {
  ca_sqrt(machine->numbers + to, machine->numbers + a, machine->context);
}

/* Calcium's order relations need a proof that the number is real, which it often lacks for sines written as
   exponentials. The caller knows it; so the sign is read off the real part, and zero is asked for by itself. */
enum calcium_sign calcium_sign_of(calcium_machine* machine, int a) {
  ca_srcptr x = machine->numbers + a;
  switch (ca_check_is_zero_no_factoring(x, machine->context)) {
    case T_TRUE:
      return calcium_zero;
    case T_UNKNOWN:
      return calcium_unknown;
    case T_FALSE:
      break;
  }
  enum calcium_sign sign = calcium_unknown;
  acb_t ball;
  acb_init(ball);
  for (slong precision = 64; sign == calcium_unknown && precision <= 4096; precision *= 2) {
    ca_get_acb(ball, x, precision, machine->context);
    if (arb_is_positive(acb_realref(ball))) sign = calcium_positive;
    if (arb_is_negative(acb_realref(ball))) sign = calcium_negative;
  }
  acb_clear(ball);
  return sign;
}
