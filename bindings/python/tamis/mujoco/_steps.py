"""A referee's answers: about each step, and about a whole run."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from tamis._arrays import Indices
from tamis._kinds import both_features
from tamis._tables._contacts import Contacts

if TYPE_CHECKING:
    import pandas


class Meeting(NamedTuple):
    """Two surfaces that touch during a step.

    Attributes
    ----------
    step : int
        The number of the step, from 0.
    first, second : str
        The model's names of the surfaces; twice the same name for a flex with itself.
    contacts : int
        The number of pairs of features that touch.
    time : float
        In simulated seconds: before this time the two are proven apart in this step.
    certified : bool
        Whether at least one contact is proven. False: on their curves none could be told from a free pair.
    """

    step: int
    first: str
    second: str
    contacts: int
    time: float
    certified: bool

    def __str__(self) -> str:
        who = f"{self.first} with itself" if self.first == self.second else f"{self.first} and {self.second}"
        return f"{who}: {self.contacts} contacts from {self.time:.9g} on"


class RefereedStep(NamedTuple):
    """One step of a simulation.

    Attributes
    ----------
    step : int
        The number of the step, from 0.
    start, end : float
        The simulated times of its ends, in seconds.
    contacts : Contacts
        The contacts. Times are fractions of the step; vertices are numbered as in `Referee.detector.mesh`.
    meetings : list of Meeting
        The same contacts by pairs of surfaces, the earliest first.
    """

    step: int
    start: float
    end: float
    contacts: Contacts
    meetings: list[Meeting]

    @property
    def is_free(self) -> bool:
        """Whether no two surfaces touch at any time of the step. True is a proof."""
        return not self.meetings

    def __str__(self) -> str:
        found = "; ".join(map(str, self.meetings)) or "free"
        return f"step {self.step}, {self.start:.9g} to {self.end:.9g}: {found}"


@dataclass
class RefereeReport:
    """The steps of a run so far.

    Attributes
    ----------
    steps : int
        The number of steps that were checked.
    meetings : list of Meeting
        The meetings in all steps, in the order of the steps.
    """

    steps: int = 0
    meetings: list[Meeting] = field(default_factory=list)

    @property
    def is_free(self) -> bool:
        """Whether no step has a contact. True is a proof."""
        return not self.meetings

    @property
    def bad_steps(self) -> list[int]:
        """The numbers of the steps that have contacts, ascending."""
        return sorted({meeting.step for meeting in self.meetings})

    def to_pandas(self) -> pandas.DataFrame:
        """Return a DataFrame with one row a meeting. pandas must be installed."""
        import pandas as pd

        return pd.DataFrame(self.meetings, columns=list(Meeting._fields))

    def __str__(self) -> str:
        if self.is_free:
            return f"{self.steps} steps, all free"
        contacts = sum(meeting.contacts for meeting in self.meetings)
        return f"{self.steps} steps, {len(self.bad_steps)} of them with contacts, {contacts} contacts"


def meetings_of(
    contacts: Contacts, groups: Indices, names: list[str], step: int, span: tuple[float, float]
) -> list[Meeting]:
    """Gather contacts by pairs of surfaces; `span` holds the simulated times of both ends of the step."""
    if not len(contacts):
        return []
    both = np.column_stack([groups[vertices[:, 0]] for vertices in both_features(contacts.kind, contacts.vertices)])
    meetings = []
    for first, second in np.unique(np.sort(both, axis=1), axis=0).tolist():
        own = contacts[(np.sort(both, axis=1) == [first, second]).all(axis=1)]
        toi = float(own.toi_lower.min())
        time = span[0] + toi * (span[1] - span[0])
        meetings.append(Meeting(step, names[first], names[second], len(own), time, bool(own.certified.any())))
    return sorted(meetings, key=lambda meeting: meeting.time)
