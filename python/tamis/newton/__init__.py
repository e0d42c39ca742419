"""Newton's cloth without a pass-through: Tamis in place of the self-contact detection of its VBD solver.

::

    import newton
    import tamis.newton

    solver = newton.solvers.SolverVBD(model, iterations=10, particle_enable_self_contact=True)
    attachment = tamis.newton.attach(solver)
    solver.step(state_in, state_out, control, contacts, dt)  # as ever

Every step then leads on straight lines, from the floats that it starts with to the floats that it ends with, past no
contact: proven. No buffer has a size to choose. Needs `newton` and `warp-lang` in the versions that
``pip install '.[newton]'`` takes, in the clone.
"""

from tamis.newton._attachment import Attachment, attach
from tamis.newton._report import AttachmentReport

__all__ = ["Attachment", "AttachmentReport", "attach"]
