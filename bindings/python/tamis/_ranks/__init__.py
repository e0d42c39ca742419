"""The parts of `tamis.distributed`."""
