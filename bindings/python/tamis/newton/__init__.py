"""Newton: Tamis instead of the self-contact detection of its VBD solver: cloth never passes through itself.

::

    import newton
    import tamis.newton

    solver = newton.solvers.SolverVBD(model, iterations=10, particle_enable_self_contact=True)
    attachment = tamis.newton.attach(solver)
    solver.step(state_in, state_out, control, contacts, dt)  # as before

The straight motion of every step, from the floats that it starts with to the floats that it ends with, is then free of
contacts, proven. No buffer sizes need be chosen. Needs `newton` and `warp-lang` in the versions of
``pip install '.[newton]'`` in the clone, as the functions that it replaces are private; the import fails without them.
"""

from tamis._versions import complaint

if _refused := complaint(["newton", "warp-lang"], "tamis.newton knows the inside of"):
    raise ImportError(_refused)

from tamis.newton._attachment import Attachment, attach
from tamis.newton._report import AttachmentReport

__all__ = ["Attachment", "AttachmentReport", "attach"]
