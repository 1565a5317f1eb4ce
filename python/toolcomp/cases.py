# SPDX-License-Identifier: Apache-2.0
"""Cases: a setup, a program and the expected events. Golden vectors and requests to controllers are cases."""

from __future__ import annotations

import json as _json
from dataclasses import dataclass, field
from typing import Any, Mapping, Tuple

from .events import Event, event_of_json


@dataclass(frozen=True)
class Case:
    """One case (corpus/schema/case.schema.json)."""

    id: str
    section: str
    #: "fanuc" or "klartext"
    dialect: str
    #: as in the schema: control, axes, parameters, offsets, tools …
    setup: Mapping[str, Any]
    program: str
    #: number of parts of a block under tool center point control; 0 gives no samples
    samples: int = 0
    comment: str = ""
    clauses: Tuple[str, ...] = ()
    flags: Tuple[str, ...] = ()
    #: the events that a golden vector expects
    expect: Tuple[Event, ...] = ()
    #: the case as it was read
    text: str = field(default="", repr=False, compare=False)

    @classmethod
    def from_json(cls, text: str) -> Case:
        """Reads a case, one JSON object."""
        json = _json.loads(text)
        return cls(
            id=json.get("id", ""),
            section=json.get("section", ""),
            dialect=json.get("dialect", "fanuc"),
            setup=json.get("setup", {}),
            program=json["program"],
            samples=json.get("samples", 0),
            comment=json.get("comment", ""),
            clauses=tuple(json.get("clauses", ())),
            flags=tuple(json.get("flags", ())),
            expect=tuple(map(event_of_json, json.get("expect", ()))),
            text=text,
        )

    def json(self) -> str:
        """The case as one line. If the case was made in Python, the line has no expected events."""
        if self.text:
            return self.text
        case: dict[str, Any] = {"case": 1, "id": self.id, "setup": dict(self.setup), "program": self.program}
        for name in ("section", "dialect", "samples", "comment"):
            if getattr(self, name):
                case[name] = getattr(self, name)
        return _json.dumps(case)
