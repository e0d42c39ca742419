// The module has no code of its own: the linker takes what bindings/c exports.
