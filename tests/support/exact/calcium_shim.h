// SPDX-License-Identifier: Apache-2.0
/* Exact numbers by Calcium, as a stack machine that C++ can call. */
#pragma once

#ifdef __cplusplus
extern "C" {
#endif

typedef struct calcium_machine calcium_machine;

/* What Calcium says of a sign; `calcium_unknown` where it does not decide. */
enum calcium_sign { calcium_negative = -1, calcium_zero = 0, calcium_positive = 1, calcium_unknown = 2 };

/* A machine with `slots` numbers, all 0. */
calcium_machine* calcium_new(int slots);
void calcium_delete(calcium_machine* machine);

/* Each sets the number in slot `to`. Rationals are written "p/q". */
void calcium_rational(calcium_machine* machine, int to, const char* value);
void calcium_sine_of_degrees(calcium_machine* machine, int to, const char* degrees);
void calcium_cosine_of_degrees(calcium_machine* machine, int to, const char* degrees);
void calcium_pi(calcium_machine* machine, int to);
void calcium_arctangent_degrees(calcium_machine* machine, int to, int a);
void calcium_negate(calcium_machine* machine, int to, int a);
void calcium_add(calcium_machine* machine, int to, int a, int b);
void calcium_subtract(calcium_machine* machine, int to, int a, int b);
void calcium_multiply(calcium_machine* machine, int to, int a, int b);
void calcium_divide(calcium_machine* machine, int to, int a, int b);
void calcium_root(calcium_machine* machine, int to, int a);

/* The sign of a real number. */
enum calcium_sign calcium_sign_of(calcium_machine* machine, int a);

#ifdef __cplusplus
}
#endif
