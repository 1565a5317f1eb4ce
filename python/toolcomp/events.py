# SPDX-License-Identifier: Apache-2.0
"""The events of a run, in order. docs/events.md describes each field. Lengths are in the units of the setup, angles in
degrees. Numbers of an exact engine are exact (:data:`toolcomp.Number`)."""

from __future__ import annotations

from dataclasses import dataclass, field, fields
from fractions import Fraction
from typing import Any, ClassVar, Literal, Mapping, Tuple, Union

from .numbers import Number, json_of_number, number_of_json

MoveType = Literal["rapid", "linear", "arc"]
Cause = Literal["programmed", "start-up", "corner", "cancel", "pre-turn", "post-turn", "reference", "measure"]
Plane = Literal["XY", "ZX", "YZ"]
Direction = Literal["cw", "ccw"]
Outcome = Literal["positive", "negative", "tie"]

#: Numbers by the letter of their axis.
AxisValues = Mapping[str, Number]
#: Components in X, Y, Z.
Vector = Tuple[Number, Number, Number]


def _is_empty(value: object) -> bool:
    return value is None or value is False or (isinstance(value, (str, tuple, Mapping)) and not value)


@dataclass(frozen=True, kw_only=True, repr=False)
class _Event:
    """The fields that all events have."""

    kind: ClassVar[str]
    #: line of the program, from 1
    line: int
    #: the sequence number, if the block has one
    n: int | None = None
    #: ids of the clauses that the event rests on, the deciding one last; only the model gives them
    clauses: Tuple[str, ...] = ()

    def __repr__(self) -> str:
        """The fields that are not empty."""
        said = ((each.name, getattr(self, each.name)) for each in fields(self))
        words = ", ".join(f"{name}={value!r}" for name, value in said if not _is_empty(value))
        return f"{type(self).__name__}({words})"


@dataclass(frozen=True, kw_only=True, repr=False)
class Move(_Event):
    """One movement."""

    kind: ClassVar[str] = "move"
    type: MoveType = "linear"
    cause: Cause = "programmed"
    #: programmed end point, absolute, in workpiece coordinates
    programmed: AxisValues = field(default_factory=dict)
    #: compensated tool point, before length offset
    point: AxisValues = field(default_factory=dict)
    #: positions that the axes are sent to, in workpiece coordinates
    axes: AxisValues = field(default_factory=dict)
    #: the positions of `axes` in machine coordinates; G53, G28, G30 and tool center point control have them
    machine: AxisValues = field(default_factory=dict)
    #: axes whose positions are unknown; no other field has them (Klartext)
    unknown: Tuple[str, ...] = ()
    #: unit vector from tip to holder
    tool_axis: Vector | None = None
    #: the feed, as F; rapid moves have none
    feed: Number | None = None
    # arcs
    center: AxisValues = field(default_factory=dict)
    plane: Plane | None = None
    direction: Direction | None = None
    #: angle of the arc that the tool runs, in degrees
    sweep: Number | None = None
    #: radius at the start and at the end, if they differ
    radius: Tuple[Number, Number] | None = None
    # Klartext
    tool_center: AxisValues = field(default_factory=dict)
    contact: AxisValues = field(default_factory=dict)
    #: unit vector of the surface normal
    normal: Vector | None = None
    shift: AxisValues = field(default_factory=dict)
    tool_shift: AxisValues = field(default_factory=dict)
    carrier: AxisValues = field(default_factory=dict)
    #: angle between normal and tool, in degrees
    angle: Number | None = None
    #: the normal is along the tool
    flat: bool = False


@dataclass(frozen=True, kw_only=True, repr=False)
class Sample(_Event):
    """A position inside a block under tool center point control."""

    kind: ClassVar[str] = "sample"
    #: the fraction of the block at which the sample is
    t: Fraction
    point: AxisValues = field(default_factory=dict)
    axes: AxisValues = field(default_factory=dict)
    machine: AxisValues = field(default_factory=dict)
    tool_axis: Vector | None = None


@dataclass(frozen=True, kw_only=True, repr=False)
class Alarm(_Event):
    """An alarm. It ends the run."""

    kind: ClassVar[str] = "alarm"
    #: the number or name that the control shows, such as "PS0041"
    number: str
    #: the cause, such as "interference", the same for all series (``toolcomp spec alarms`` lists them); None if a
    #: controller does not give it
    cause: str | None = None
    message: str = ""


@dataclass(frozen=True, kw_only=True, repr=False)
class Warning(_Event):
    """A warning. The run goes on."""

    kind: ClassVar[str] = "warning"
    number: str
    message: str = ""


@dataclass(frozen=True, kw_only=True, repr=False)
class Hole(_Event):
    """A hole of a canned cycle. The event does not describe the movement between its beginning and its end."""

    kind: ClassVar[str] = "hole"
    #: position of the linear axes without the drilling axis, before length offset
    point: AxisValues = field(default_factory=dict)
    #: point R and the bottom, as coordinates along the drilling axis
    r: Number | None = None
    bottom: Number | None = None
    #: the level to which the tool returns; `return` in JSON
    level: Number | None = None
    #: positions of the axes after the hole, in workpiece coordinates
    axes: AxisValues = field(default_factory=dict)


@dataclass(frozen=True, kw_only=True, repr=False)
class Setting(_Event):
    """A value written to the offset memory (G10, G37)."""

    kind: ClassVar[str] = "setting"
    #: the value that was set, such as "H1" or "H1.wear"
    name: str
    value: Number


@dataclass(frozen=True, kw_only=True, repr=False)
class Undecided(_Event):
    """The specification leaves open what the block does, or a sign could not be certified."""

    kind: ClassVar[str] = "undecided"
    clause: str = ""
    permitted: Tuple[Outcome, ...] = ()
    #: "OUT_OF_SCOPE" if the model does not cover what the block does
    reason: str = ""


@dataclass(frozen=True, kw_only=True, repr=False)
class NotSupported(_Event):
    """The run ends, without an alarm, at a word that a control may well run and toolcomp does not."""

    kind: ClassVar[str] = "not_supported"
    #: the word of the program, such as "G81"
    code: str = ""
    message: str = ""


@dataclass(frozen=True, kw_only=True, repr=False)
class NotJudged(_Event):
    """The run ends, without an alarm, at a word after which toolcomp cannot compute positions."""

    kind: ClassVar[str] = "not_judged"
    #: the words of the program, such as "PLANE SPATIAL"
    code: str = ""
    message: str = ""


@dataclass(frozen=True, kw_only=True, repr=False)
class Note(_Event):
    """A note of `toolcomp run` for the reader of a program. No verdict depends on it."""

    kind: ClassVar[str] = "note"
    text: str = ""


Event = Union[Move, Sample, Alarm, Warning, Setting, Undecided, NotSupported, NotJudged, Hole, Note]

_KINDS: dict[str, type[Event]] = {
    "move": Move,
    "sample": Sample,
    "alarm": Alarm,
    "warning": Warning,
    "setting": Setting,
    "undecided": Undecided,
    "not_supported": NotSupported,
    "not_judged": NotJudged,
    "hole": Hole,
    "note": Note,
}
_AXES = {"programmed", "point", "axes", "machine", "center", "tool_center", "contact", "shift", "tool_shift", "carrier"}
_TUPLES = {"tool_axis", "normal", "radius"}
_NUMBERS = {"feed", "sweep", "angle", "value", "r", "bottom", "level"}
_NAMES = {"clauses", "permitted", "unknown"}
#: A word of the language cannot be the name of an attribute.
_ATTRIBUTES = {"return": "level"}
_FIELDS = {attribute: name for name, attribute in _ATTRIBUTES.items()}


def _read(name: str, json: Any) -> Any:
    if name in _AXES:
        return {axis: number_of_json(value) for axis, value in json.items()}
    if name in _TUPLES:
        return tuple(map(number_of_json, json))
    if name in _NUMBERS:
        return number_of_json(json)
    if name in _NAMES:
        return tuple(json)
    return Fraction(json) if name == "t" else json


def event_of_json(json: Mapping[str, Any]) -> Event:
    """An event from its JSON object, in the form of the extension, of a golden vector or of the protocol."""
    named = ((_ATTRIBUTES.get(name, name), value) for name, value in json.items() if name != "kind")
    return _KINDS[json["kind"]](**{name: _read(name, value) for name, value in named})


def _write(name: str, value: Any) -> Any:
    if name in _AXES:
        return {axis: json_of_number(number) for axis, number in value.items()}
    if name in _TUPLES:
        return [json_of_number(number) for number in value]
    if name in _NUMBERS:
        return json_of_number(value)
    if name in _NAMES:
        return list(value)
    return f"{value.numerator}/{value.denominator}" if name == "t" else value


def json_of_event(event: Event | Mapping[str, Any]) -> dict[str, Any]:
    """The JSON object of an event for the protocol, without empty fields. A mapping is taken as such an object, and its
    numbers are written out."""
    if isinstance(event, Mapping):
        return {name: _write(_ATTRIBUTES.get(name, name), value) for name, value in event.items()}
    written = {"kind": event.kind, "line": event.line}
    for each in fields(event):
        value = getattr(event, each.name)
        if each.name == "line" or (_is_empty(value) and each.name != "permitted"):
            continue
        written[_FIELDS.get(each.name, each.name)] = _write(each.name, value)
    return written
