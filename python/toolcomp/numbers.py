# SPDX-License-Identifier: Apache-2.0
"""Exact values: a Fraction if the value is rational, otherwise a decimal with an error bound."""

from __future__ import annotations

from dataclasses import dataclass
from decimal import Decimal, localcontext
from fractions import Fraction
from typing import Any, Union


@dataclass(frozen=True)
class Exact:
    """A real number that is not a fraction. It is certified to be between ``value - radius`` and ``value + radius``."""

    value: Decimal
    radius: Decimal

    def __float__(self) -> float:
        return float(self.value)

    def __str__(self) -> str:
        return f"{self.value} ± {self.radius}"

    @property
    def lower(self) -> Fraction:
        """The exact lower bound."""
        return Fraction(self.value) - Fraction(self.radius)

    @property
    def upper(self) -> Fraction:
        """The exact upper bound."""
        return Fraction(self.value) + Fraction(self.radius)

    def contains(self, number: int | float | Decimal | Fraction) -> bool:
        """Whether the real number may be this number."""
        return self.lower <= Fraction(number) <= self.upper


#: A number of an event. The model gives Fraction or Exact, the fast engine gives float, and a controller may give any
#: of them. ``float()`` accepts all of them.
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


#: Number of decimals of a fraction whose decimals do not end.
_DECIMALS = 40


def json_of_number(number: Any) -> Any:
    """A number in the form of the protocol: exact digits become text; doubles and text stay as they are.

    :raises TypeError: if it is not a number
    """
    if isinstance(number, bool):
        raise TypeError(f"{number!r} is not a number")
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
    raise TypeError(f"{number!r} is not a number")


def _decimal_text(number: Fraction) -> str:
    with localcontext() as context:
        context.prec = _DECIMALS + len(str(abs(number.numerator)))
        return format(Decimal(number.numerator) / Decimal(number.denominator), "f")
