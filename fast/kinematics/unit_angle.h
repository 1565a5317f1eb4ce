// SPDX-License-Identifier: Apache-2.0
// The angles of unit vectors, without a division.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "fast/arithmetic/trigonometry.h"

namespace toolcomp::fast {

// The angle whose sine is i / 64: its cosine, and itself in degrees as a sum of two doubles.
struct UnitAngle {
  double cosine, angle, rest;
};
inline constexpr std::array<UnitAngle, 47> kUnitAngles{{
    {0x1p+0, 0x0.0p+0, 0x0.0p+0},
    {0x1.ffefffbffdfffp-1, 0x1.ca628817f7c3fp-1, 0x1.504fa9be14bbep-55},
    {0x1.ffbffbff7fec0p-1, 0x1.ca70dd09ff101p+0, -0x1.ffd8e89d3ae19p-56},
    {0x1.ff6febba4bfeap-1, 0x1.57e693ff75751p+1, -0x1.c18c34995c17fp-55},
    {0x1.feffbfdfebf1fp-1, 0x1.caaa4910fdfd7p+1, 0x1.6bdd69fb234dbp-57},
    {0x1.fe6f634576477p-1, 0x1.1ec5684570018p+2, -0x1.d019c554e7aeep-52},
    {0x1.fdbeba917c3f5p-1, 0x1.5847bed1e769dp+2, 0x1.d7580c5741be8p-54},
    {0x1.fceda421efdb5p-1, 0x1.91dfdc20e0847p+2, 0x1.701ceceee6413p-55},
    {0x1.fbfbf7ebc755fp-1, 0x1.cb9180b27b479p+2, -0x1.6c6a0f548b142p-52},
    {0x1.fae987541497fp-1, 0x1.02b03deeecd28p+3, 0x1.57a0d9177f788p-53},
    {0x1.f9b61d0237250p-1, 0x1.1fa85719adb61p+3, 0x1.42a86dc264a3ap-52},
    {0x1.f8617caabd6f6p-1, 0x1.3cb305fdc65fbp+3, 0x1.6cb17b91efd32p-51},
    {0x1.f6eb62d27730dp-1, 0x1.59d24febbd6c4p+3, 0x1.ada54973f6814p-51},
    {0x1.f553848924e81p-1, 0x1.770846c3ca4bep+3, 0x1.ab37a81789a43p-53},
    {0x1.f3998f1b1886cp-1, 0x1.94570a6f615d9p+3, -0x1.83afa1548a563p-51},
    {0x1.f1bd27b9002c4p-1, 0x1.b1c0ca7400da1p+3, 0x1.fa3995005db6cp-51},
    {0x1.efbdeb14f4edap-1, 0x1.cf47c7a2c0560p+3, -0x1.e8860616e3805p-51},
    {0x1.ed9b6cf3c4663p-1, 0x1.ecee55e89175ap+3, -0x1.ccc42d6274081p-51},
    {0x1.eb5537b1434dap-1, 0x1.055b6f21d008bp+4, 0x1.fb1281e8b9c18p-50},
    {0x1.e8eacbb648910p-1, 0x1.1451f0716ae8ap+4, -0x1.d680747ddee16p-50},
    {0x1.e65b9edeba38ep-1, 0x1.235bfbba9aa8fp+4, -0x1.cb47471816416p-53},
    {0x1.e3a71bcdd63dep-1, 0x1.327aebd7c81bdp+4, -0x1.18c2054e638c8p-54},
    {0x1.e0cca12e97895p-1, 0x1.41b02b08081d4p+4, -0x1.ec56db01d49a9p-52},
    {0x1.ddcb80ddc085bp-1, 0x1.50fd3474166a1p+4, 0x1.4b8961a823ed1p-50},
    {0x1.daa2fefaae1d8p-1, 0x1.606395db7f815p+4, -0x1.4631ef00dd0b6p-50},
    {0x1.d75250db9c792p-1, 0x1.6fe4f16fbf100p+4, -0x1.da87cbc782223p-51},
    {0x1.d3d89be176072p-1, 0x1.7f82ffe40d3ffp+4, 0x1.97bd22fcdbe85p-53},
    {0x1.d034f42698214p-1, 0x1.8f3f92b9bb29ep+4, 0x1.6e8cc5ac3143fp-50},
    {0x1.cc665b0328622p-1, 0x1.9f1c96d26100dp+4, 0x1.998766812b5fep-51},
    {0x1.c86bbd609a260p-1, 0x1.af1c1752cda74p+4, 0x1.d5aad9a049763p-50},
    {0x1.c443f1d4d22afp-1, 0x1.bf4040e3b191ep+4, 0x1.4ff5b84b79501p-50},
    {0x1.bfedb67be13b3p-1, 0x1.cf8b655f7d9a6p+4, -0x1.c36f494b5e82dp-50},
    {0x1.bb67ae8584caap-1, 0x1.e000000000000p+4, 0x1p-294},
    {0x1.b6b05f6966b9bp-1, 0x1.f0a0ba2215a86p+4, -0x1.d17050a0508eep-51},
    {0x1.b1c62db2564fep-1, 0x1.00b8385d3faa0p+5, 0x1.e8860616e3805p-49},
    {0x1.aca7594d44cbdp-1, 0x1.09391d4e6b012p+5, 0x1.2d6c8fab57b45p-51},
    {0x1.a751f9447b724p-1, 0x1.11d4b7de88e29p+5, 0x1.8453e2dfda13cp-49},
    {0x1.a1c3f6ca01f29p-1, 0x1.1a8cd8ceca48cp+5, -0x1.19709ff784206p-49},
    {0x1.9bfb076d236ebp-1, 0x1.23637a93ea145p+5, -0x1.7d2ce8410b927p-50},
    {0x1.95f4a64decda8p-1, 0x1.2c5ac71ebaa0ep+5, -0x1.5ad5ddec68fd0p-49},
    {0x1.8fae0c15ad38ap-1, 0x1.35751eb213d45p+5, -0x1.3e282f55bad4ep-51},
    {0x1.8924256bf4545p-1, 0x1.3eb52004c6f5ep+5, 0x1.effa38095bd93p-49},
    {0x1.8253878ae2e09p-1, 0x1.481db20030ec9p+5, -0x1.60a69738ddd21p-49},
    {0x1.7b386279d7bf3p-1, 0x1.51b20f842c525p+5, 0x1.382ef43422a8dp-49},
    {0x1.73ce704fb7b23p-1, 0x1.5b75d5ba10408p+5, -0x1.6e6484912aa03p-49},
    {0x1.6c10e0a9e5d65p-1, 0x1.656d15addf43dp+5, -0x1.06f5bfedee43bp-50},
    {0x1.63fa3f3c02962p-1, 0x1.6f9c6a24807ebp+5, 0x1.4631ef00dd0b6p-49},
}};

// The angles of (cosine, sine) in degrees, in (-180, 180], one a lane: as arctangent(), for vectors of length 1.
// Relative error at most kUnitAngleError, and what the length is off by; exact at multiples of 90.
inline constexpr double kUnitAngleError = 6 * 0x1p-53;
[[gnu::always_inline]] inline DoublePair unit_angle(DoublePair sine, DoublePair cosine) {
  using BitPair [[gnu::vector_size(16)]] = std::uint64_t;
  const auto magnitude = [](DoublePair value) {
    return std::bit_cast<DoublePair>(std::bit_cast<BitPair>(value) << 1 >> 1);
  };
  const DoublePair a = magnitude(sine);
  const DoublePair b = magnitude(cosine);
  const DoublePair x = a > b ? a : b;
  const DoublePair y = a > b ? b : a;
  // From the angle of the nearest sine of the table: y c - x s by differences that are exact, so that only the rounding
  // of c counts, u s c, u = 2^-53; the arc sine of it below 1/88, whose next term is below 2^-57 of it.
  constexpr double kShift = 0x1.8p52;
  const DoublePair shifted = y * 64.0 + kShift;
  const auto index = std::bit_cast<BitPair>(shifted);
  const UnitAngle& first = kUnitAngles[index[0] % 64];
  const UnitAngle& second = kUnitAngles[index[1] % 64];
  const DoublePair s = (shifted - kShift) * (1.0 / 64);
  const DoublePair c{first.cosine, second.cosine};
  const DoublePair d = (y - s) * c - (x - c) * s;
  const DoublePair z = d * d;
  const DoublePair rest =
      DoublePair{first.rest, second.rest} +
      d * (0x1.ca5dc1a63c1f8p+5 + z * (0x1.3193d66ed2bfap+3 + z * (0x1.13050dca2412ep+2 + z * 0x1.47678a522af1fp+1)));
  const DoublePair angle = DoublePair{first.angle, second.angle} + rest;
  const DoublePair upper = a > b ? 90.0 - angle : angle;
  const DoublePair half = cosine < 0.0 ? 180.0 - upper : upper;
  return sine < 0.0 ? -half : half;
}

}  // namespace toolcomp::fast
