// The steps that the site brings along, each in a script of its own: also a page that is opened from a file reads scripts.
import { inflated } from "./inflate";
import type { Source } from "./program";

declare global {
  interface Window {
    /** Start and end of each step that has been loaded: compressed PLY files, in base64. */
    tamisSteps?: Record<string, [string, string] | undefined>;
  }
}

/** Runs a script that stands beside the page. */
export function runScript(address: string): Promise<void> {
  return new Promise((done, refuse) => {
    const script = document.createElement("script");
    script.src = address;
    script.onload = () => {
      done();
    };
    script.onerror = () => {
      refuse(new Error(`${address} cannot be loaded: load this page again`));
    };
    document.head.append(script);
  });
}

export function builtIn(name: string): Source {
  return async () => {
    if (!window.tamisSteps?.[name]) await runScript(`step-${name}.js`);
    const texts = window.tamisSteps?.[name];
    if (!texts) throw new Error(`step-${name}.js holds no step: load this page again`);
    const [start, end] = await Promise.all(texts.map(inflated));
    return [
      { name: `${name} start.ply`, bytes: start },
      { name: `${name} end.ply`, bytes: end },
    ];
  };
}
