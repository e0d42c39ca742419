"""Newton: Tamis instead of the self-contact detection of its VBD solver: cloth never passes through itself.

::

    import newton
    import tamis.newton

    solver = newton.solvers.SolverVBD(model, iterations=10, particle_enable_self_contact=True)
    attachment = tamis.newton.attach(solver)
    solver.step(state_in, state_out, control, contacts, dt)  # as before

The straight motion of every step, from the floats that it starts with to the floats that it ends with, is then free of
contacts, proven. No buffer sizes need be chosen. Needs `newton` (``pip install '.[newton]'`` in
the clone). The functions that it replaces are private: the import fails if they differ from the tested ones.
"""

from tamis._versions import check_sources
from tamis.newton._inside import KNOWN, PACKAGE, TESTED

check_sources(PACKAGE, TESTED, KNOWN, "tamis.newton")

from tamis.newton._attachment import Attachment, attach  # noqa: E402
from tamis.newton._report import AttachmentReport  # noqa: E402

__all__ = ["Attachment", "AttachmentReport", "attach"]
