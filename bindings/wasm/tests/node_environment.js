// Programs of tests see Node's environment variables, such as TAMIS_DATA.
Module.preRun = [() => Object.assign(ENV, process.env)];
