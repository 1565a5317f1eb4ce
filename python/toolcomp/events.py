# SPDX-License-Identifier: Apache-2.0
"""Events: what a run yields, in order. docs/events.md says what each field means; lengths are in the units of the
setup, angles in degrees, numbers exact where an exact engine gave them (:data:`toolcomp.Number`)."""

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
    """What all events have."""

    kind: ClassVar[str]
    #: of the program, from 1
    line: int
    #: the sequence number, where the block has one
    n: int | None = None
    #: ids of the clauses it rests on, the deciding one last; the model gives them
    clauses: Tuple[str, ...] = ()

    def __repr__(self) -> str:
        """The fields that it has."""
        said = ((each.name, getattr(self, each.name)) for each in fields(self))
        words = ", ".join(f"{name}={value!r}" for name, value in said if not _is_empty(value))
        return f"{type(self).__name__}({words})"


@dataclass(frozen=True, kw_only=True, repr=False)
class Move(_Event):
    """One movement."""

    kind: ClassVar[str] = "move"
    type: MoveType = "linear"
    cause: Cause = "programmed"
    #: programmed end point, absolute, workpiece coordinates
    programmed: AxisValues = field(default_factory=dict)
    #: compensated tool point, before length offset
    point: AxisValues = field(default_factory=dict)
    #: what the axes are sent to, workpiece coordinates
    axes: AxisValues = field(default_factory=dict)
    #: the same in machine coordinates: G53, G28, G30, tool center point control
    machine: AxisValues = field(default_factory=dict)
    #: axes of which nobody knows where they stand; no other field has them (Klartext)
    unknown: Tuple[str, ...] = ()
    #: unit vector from tip to holder
    tool_axis: Vector | None = None
    #: as F; not of rapid moves
    feed: Number | None = None
    # arcs
    center: AxisValues = field(default_factory=dict)
    plane: Plane | None = None
    direction: Direction | None = None
    #: degrees of the tool's own arc
    sweep: Number | None = None
    #: at start and end, where they differ
    radius: Tuple[Number, Number] | None = None
    # Klartext
    tool_center: AxisValues = field(default_factory=dict)
    contact: AxisValues = field(default_factory=dict)
    #: surface normal, unit
    normal: Vector | None = None
    shift: AxisValues = field(default_factory=dict)
    tool_shift: AxisValues = field(default_factory=dict)
    carrier: AxisValues = field(default_factory=dict)
    #: degrees between normal and tool
    angle: Number | None = None
    #: the normal is along the tool
    flat: bool = False


@dataclass(frozen=True, kw_only=True, repr=False)
class Sample(_Event):
    """A position inside a block under tool center point control."""

    kind: ClassVar[str] = "sample"
    #: which part of the block lies behind it
    t: Fraction
    point: AxisValues = field(default_factory=dict)
    axes: AxisValues = field(default_factory=dict)
    machine: AxisValues = field(default_factory=dict)
    tool_axis: Vector | None = None


@dataclass(frozen=True, kw_only=True, repr=False)
class Alarm(_Event):
    """An alarm: it ends the run."""

    kind: ClassVar[str] = "alarm"
    #: what the control shows: "PS0041", or a name of ours
    number: str
    #: why, the same for all series (``toolcomp spec alarms``): "interference"; None where a controller does not say
    cause: str | None = None
    message: str = ""


@dataclass(frozen=True, kw_only=True, repr=False)
class Warning(_Event):
    """A warning: the run goes on."""

    kind: ClassVar[str] = "warning"
    number: str
    message: str = ""


@dataclass(frozen=True, kw_only=True, repr=False)
class Hole(_Event):
    """A hole of a canned cycle. What happens between its beginning and its end is not said."""

    kind: ClassVar[str] = "hole"
    #: position: the linear axes but the drilling axis, before length offset
    point: AxisValues = field(default_factory=dict)
    #: point R and the bottom, coordinates along the drilling axis
    r: Number | None = None
    bottom: Number | None = None
    #: to which the tool returns: `return` in JSON
    level: Number | None = None
    #: where the axes stand behind it, workpiece coordinates
    axes: AxisValues = field(default_factory=dict)


@dataclass(frozen=True, kw_only=True, repr=False)
class Setting(_Event):
    """A value written to the offset memory (G10, G37)."""

    kind: ClassVar[str] = "setting"
    #: "H1", "H1.wear"
    name: str
    value: Number


@dataclass(frozen=True, kw_only=True, repr=False)
class Undecided(_Event):
    """The specification leaves open what happens, or a sign could not be certified."""

    kind: ClassVar[str] = "undecided"
    clause: str = ""
    permitted: Tuple[Outcome, ...] = ()
    #: "OUT_OF_SCOPE": what follows is not modelled
    reason: str = ""


@dataclass(frozen=True, kw_only=True, repr=False)
class NotSupported(_Event):
    """The run ends at what a control may well run and toolcomp does not: no alarm."""

    kind: ClassVar[str] = "not_supported"
    #: what stands in the program: "G81"
    code: str = ""
    message: str = ""


@dataclass(frozen=True, kw_only=True, repr=False)
class NotJudged(_Event):
    """The run ends at what makes positions unknown: no alarm."""

    kind: ClassVar[str] = "not_judged"
    #: what stands in the program: "PLANE SPATIAL"
    code: str = ""
    message: str = ""


@dataclass(frozen=True, kw_only=True, repr=False)
class Note(_Event):
    """What a reader of the program should know: `toolcomp run` says it, and no verdict depends on it."""

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
    """An event from its JSON object, as the extension, a golden vector or the protocol has it."""
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
    """The JSON object of an event for the protocol; what is empty is left out. A mapping is taken as one, its numbers
    written out."""
    if isinstance(event, Mapping):
        return {name: _write(_ATTRIBUTES.get(name, name), value) for name, value in event.items()}
    written = {"kind": event.kind, "line": event.line}
    for each in fields(event):
        value = getattr(event, each.name)
        if each.name == "line" or (_is_empty(value) and each.name != "permitted"):
            continue
        written[_FIELDS.get(each.name, each.name)] = _write(each.name, value)
    return written
