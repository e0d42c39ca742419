// Programs that read environment variables, such as TAMIS_DATA, see Node's.
Module.preRun = [() => typeof ENV === 'undefined' || Object.assign(ENV, process.env)];
