# SPDX-License-Identifier: Apache-2.0
"""Controllers written in Python: they turn a function or an object into lines of the protocol (docs/protocol.md)."""

from __future__ import annotations

import json
from typing import Any, Callable, Iterable, Mapping, Protocol, Sequence, Union, runtime_checkable

from . import _core
from .cases import Case
from .errors import NotApplicable
from .events import Event, json_of_event

#: The result of a controller for a case: events, or mappings with the fields of the protocol.
Events = Iterable[Union[Event, Mapping[str, Any]]]


@runtime_checkable
class ControllerLike(Protocol):
    """An object that announces its capabilities and answers cases. If the object keeps a state from case to case, it
    needs a method ``restart()``, which is called when a command would be started again."""

    def hello(self) -> Mapping[str, Any]:
        """name, version, sections, fields … as in docs/protocol.md."""

    def answer(self, case: Case) -> Events:
        """The events of a case. May raise :class:`toolcomp.NotApplicable`."""


#: A function from a case to events, or an object with ``hello`` and ``answer``.
PythonController = Union[Callable[[Case], Events], ControllerLike]


def words_of_exception(error: BaseException) -> str:
    """An exception in one line: "ValueError: no such tool"."""
    words = " ".join(str(error).split())
    return f"{type(error).__name__}: {words}" if words else type(error).__name__


class _Lines:
    """Both sides of the protocol, as lines."""

    def __init__(self, controller: PythonController, sections: Sequence[str], fields: Sequence[str]) -> None:
        self._controller = controller
        self._sections = sections
        self._fields = fields

    def hello(self) -> str:
        """The answer to hello."""
        if isinstance(self._controller, ControllerLike):
            said: dict[str, Any] = {"protocol": 1, **self._controller.hello()}
        else:
            said = {
                "protocol": 1,
                "name": getattr(self._controller, "__name__", type(self._controller).__name__),
                "version": "",
                "sections": list(self._sections or _core.sections()),
                "fields": list(self._fields),
            }
        return json.dumps(said)

    def answer(self, request: str) -> str:
        """The answer to a case."""
        case = Case.from_json(request)
        ask = self._controller.answer if isinstance(self._controller, ControllerLike) else self._controller
        try:
            events = ask(case)
            if isinstance(events, (str, bytes)) or not hasattr(events, "__iter__"):
                # The judge says what is wrong with it.
                return json.dumps({"id": case.id, "events": repr(events)})
            return json.dumps({"id": case.id, "events": [json_of_event(event) for event in events]})
        except NotApplicable as error:
            return json.dumps({"id": case.id, "not_applicable": str(error) or "not applicable"})


def bound(
    controller: PythonController, sections: Sequence[str], fields: Sequence[str], raise_errors: bool
) -> _core.PythonController:
    """The controller as the extension calls it."""
    lines = _Lines(controller, sections, fields)
    return _core.PythonController(lines.hello, lines.answer, getattr(controller, "restart", None), raise_errors)
