// SPDX-License-Identifier: Apache-2.0
// What exact numbers cost: single operations, a leading-edge vector as a whole, and proofs of zero.
#include <benchmark/benchmark.h>

#include "model/exact/vector.h"

namespace {

using toolcomp::exact::cos_degrees;
using toolcomp::exact::cross;
using toolcomp::exact::dot;
using toolcomp::exact::Rational;
using toolcomp::exact::Real;
using toolcomp::exact::sin_degrees;
using toolcomp::exact::squared_norm;
using toolcomp::exact::Vector3;

// A new angle in thousandths of a degree each time.
Rational angle(int i) { return {((i * 7919) % 90000) + 1, 1000}; }

void add(benchmark::State& state) {
  const Real a = sin_degrees(angle(1));
  const Real b = cos_degrees(angle(2));
  for (auto _ : state) benchmark::DoNotOptimize(a + b);
}
BENCHMARK(add)->Name("exact/add");

void multiply(benchmark::State& state) {
  const Real a = sin_degrees(angle(1));
  const Real b = cos_degrees(angle(2));
  for (auto _ : state) benchmark::DoNotOptimize(a * b);
}
BENCHMARK(multiply)->Name("exact/multiply");

void divide(benchmark::State& state) {
  const Real a = sin_degrees(angle(1));
  const Real b = cos_degrees(angle(2));
  for (auto _ : state) benchmark::DoNotOptimize(a / b);
}
BENCHMARK(divide)->Name("exact/divide");

void root(benchmark::State& state) {
  const Real a = sin_degrees(angle(1));
  for (auto _ : state) benchmark::DoNotOptimize(sqrt(a));
}
BENCHMARK(root)->Name("exact/sqrt");

void add_rationals(benchmark::State& state) {
  const Real a = Rational(12345, 1000);
  const Real b = Rational(-6789, 10000);
  for (auto _ : state) benchmark::DoNotOptimize(a + b);
}
BENCHMARK(add_rationals)->Name("exact/rational_add");

void multiply_rationals(benchmark::State& state) {
  const Real a = Rational(12345, 1000);
  const Real b = Rational(-6789, 10000);
  for (auto _ : state) benchmark::DoNotOptimize(a * b);
}
BENCHMARK(multiply_rationals)->Name("exact/rational_multiply");

void sine_and_cosine(benchmark::State& state) {
  int i = 0;
  for (auto _ : state) {
    const Rational degrees = angle(++i);
    benchmark::DoNotOptimize(sin_degrees(degrees));
    benchmark::DoNotOptimize(cos_degrees(degrees));
  }
}
BENCHMARK(sine_and_cosine)->Name("exact/sin_and_cos_of_a_new_angle");

Vector3 tool_direction(const Rational& b, const Rational& c) {
  return {sin_degrees(b) * cos_degrees(c), sin_degrees(b) * sin_degrees(c), cos_degrees(b)};
}

// VT turned by two angles, one of them new; VC = R (VT x VM) x VT / |..|; the sign that chooses the side.
void leading_edge(benchmark::State& state) {
  int i = 0;
  const Real radius = Rational(1234, 1000);
  const Rational b(123, 10);
  for (auto _ : state) {
    ++i;
    const Vector3 tool = tool_direction(b, angle(i));
    const Vector3 move{Rational((i % 997) + 1, 1000), Rational((i % 911) - 400, 1000), Rational((i % 13) - 6, 1000)};
    const Vector3 normal = cross(tool, move);
    const Vector3 direction = cross(normal, tool);
    const Real factor = radius / sqrt(squared_norm(direction));
    benchmark::DoNotOptimize(dot(tool, move).sign());
    benchmark::DoNotOptimize(normal.x.sign());
    benchmark::DoNotOptimize(factor * direction);
  }
}
BENCHMARK(leading_edge)->Name("exact/leading_edge_vector");

// The same with its three coordinates printed to 9 decimals.
void leading_edge_printed(benchmark::State& state) {
  int i = 0;
  const Real radius = Rational(1234, 1000);
  for (auto _ : state) {
    ++i;
    const Vector3 tool = tool_direction(Rational(123, 10), angle(i));
    const Vector3 move{Rational((i % 997) + 1, 1000), Rational((i % 911) - 400, 1000), Rational((i % 13) - 6, 1000)};
    const Vector3 direction = cross(cross(tool, move), tool);
    const Vector3 edge = radius / sqrt(squared_norm(direction)) * direction;
    benchmark::DoNotOptimize(edge.x.decimal(9));
    benchmark::DoNotOptimize(edge.y.decimal(9));
    benchmark::DoNotOptimize(edge.z.decimal(9));
  }
}
BENCHMARK(leading_edge_printed)->Name("exact/leading_edge_vector_printed");

// sin(a + b) - sin a cos b - cos a sin b.
void prove_angle_addition(benchmark::State& state) {
  int i = 0;
  for (auto _ : state) {
    const Rational a = angle(++i);
    const Rational b = angle(i + 50);
    const Real zero = sin_degrees(a + b) - sin_degrees(a) * cos_degrees(b) - cos_degrees(a) * sin_degrees(b);
    benchmark::DoNotOptimize(zero.sign());
  }
}
BENCHMARK(prove_angle_addition)->Name("exact/prove_angle_addition");

// Three moves in one plane turned by two angles: their triple product.
void prove_coplanar(benchmark::State& state) {
  int i = 0;
  for (auto _ : state) {
    ++i;
    const Vector3 u = tool_direction(angle(i), angle(i + 30));
    const Vector3 v{cos_degrees(angle(i)) * cos_degrees(angle(i + 30)),
                    cos_degrees(angle(i)) * sin_degrees(angle(i + 30)), -sin_degrees(angle(i))};
    const Vector3 w = Real(Rational(3, 7)) * u + Real(Rational(-11, 5)) * v;
    benchmark::DoNotOptimize(dot(cross(u, v), w).sign());
  }
}
BENCHMARK(prove_coplanar)->Name("exact/prove_coplanar");

// |VC| = R, with the root and three divisions.
void prove_length(benchmark::State& state) {
  int i = 0;
  for (auto _ : state) {
    ++i;
    const Vector3 tool = tool_direction(angle(i), angle(i + 30));
    const Vector3 move{Rational((i % 997) + 1, 1000), Rational((i % 911) - 400, 1000), Rational((i % 13) - 6, 1000)};
    const Vector3 direction = cross(cross(tool, move), tool);
    const Vector3 unit = direction / sqrt(squared_norm(direction));
    benchmark::DoNotOptimize((squared_norm(unit) - 1).sign());
  }
}
BENCHMARK(prove_length)->Name("exact/prove_unit_length");

}  // namespace
