# SPDX-License-Identifier: Apache-2.0
"""Exact values: a Fraction where a value is rational, else a decimal and how far off it may be."""

from __future__ import annotations

from dataclasses import dataclass
from decimal import Decimal, localcontext
from fractions import Fraction
from typing import Any, Union


@dataclass(frozen=True)
class Exact:
    """A real number that is no fraction: it lies between ``value - radius`` and ``value + radius``, certified."""

    value: Decimal
    radius: Decimal

    def __float__(self) -> float:
        return float(self.value)

    def __str__(self) -> str:
        return f"{self.value} ± {self.radius}"

    @property
    def lower(self) -> Fraction:
        """The lower bound, exactly."""
        return Fraction(self.value) - Fraction(self.radius)

    @property
    def upper(self) -> Fraction:
        """The upper bound, exactly."""
        return Fraction(self.value) + Fraction(self.radius)

    def contains(self, number: int | float | Decimal | Fraction) -> bool:
        """Whether the number may be the one that is meant."""
        return self.lower <= Fraction(number) <= self.upper


#: A number of an event: of the model Fraction or Exact, of the fast engine float; a controller may give any of them.
#: ``float()`` takes all of them.
Number = Union[Fraction, Exact, Decimal, float]


def number_of_json(json: Any) -> Number:
    """A number as the extension or a golden vector writes it."""
    if isinstance(json, str):
        return Fraction(json)
    if isinstance(json, list):
        return Exact(Decimal(json[0]), Decimal(json[1]))
    if isinstance(json, dict):
        if "q" in json:
            return Fraction(json["q"])
        return Exact(Decimal(json["v"]), Decimal(json["r"])) if "r" in json else Fraction(json["v"])
    return float(json)


#: Decimals of a fraction that has no end.
_DECIMALS = 40


def json_of_number(number: Any) -> Any:
    """A number as the protocol takes it: digits are kept as text, doubles as they are, text as it is.

    :raises TypeError: for what is no number
    """
    if isinstance(number, bool):
        raise TypeError(f"{number!r} is no number")
    if isinstance(number, str):
        return number
    if isinstance(number, int):
        return str(number)
    if isinstance(number, float):
        # JSON has no infinities: as text they are what they are, no number.
        return float(number) if abs(number) < float("inf") else repr(float(number))
    if isinstance(number, Exact):
        return format(number.value, "f")
    if isinstance(number, Decimal):
        return format(number, "f")
    if isinstance(number, Fraction):
        return _decimal_text(number)
    if hasattr(number, "__float__"):
        return json_of_number(float(number))
    raise TypeError(f"{number!r} is no number")


def _decimal_text(number: Fraction) -> str:
    with localcontext() as context:
        context.prec = _DECIMALS + len(str(abs(number.numerator)))
        return format(Decimal(number.numerator) / Decimal(number.denominator), "f")
