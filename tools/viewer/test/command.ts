// Runs the built command in a folder of its own.
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

const command = process.env.TAMIS_COMMAND;
if (!command) throw new Error("TAMIS_COMMAND must name the command to test");

export interface Row {
  kind: string;
  vertices: number[];
  toiLower: number;
  toiUpper: number;
  u: number;
  v: number;
  status: string;
}

export class Folder {
  readonly path = mkdtempSync(join(tmpdir(), "tamis-viewer-"));

  remove(): void {
    rmSync(this.path, { recursive: true, force: true });
  }

  file(name: string): string {
    return join(this.path, name);
  }

  write(name: string, text: string): void {
    writeFileSync(this.file(name), text);
  }

  /** Runs the command; throws unless it ends with the expected exit code. Arguments may not contain blanks. */
  run(line: string, expected = 0): string {
    const { status, stdout, stderr } = spawnSync(command!, line.split(" "), {
      cwd: this.path,
      encoding: "utf8",
      maxBuffer: 2 ** 30,
    });
    if (status !== expected) throw new Error(`tamis ${line}: exit code ${status}: ${stderr}`);
    return stdout;
  }

  /** Returns the contacts of a step from the command's table. */
  contacts(arguments_: string): Row[] {
    this.run(`contacts ${arguments_} --out rows.csv`);
    const [, ...lines] = readFileSync(this.file("rows.csv"), "utf8").trim().split("\n");
    return lines.map((line) => {
      const cells = line.split(",");
      const [kind, status] = [cells[0], cells[9]];
      const [a, b, c, d, toiLower, toiUpper, u, v] = cells.slice(1, 9).map(Number);
      return { kind, vertices: [a, b, c, d], toiLower, toiUpper, u, v, status };
    });
  }
}

/** Returns the OBJ text of vertices and elements. */
export function obj(vertices: number[][], rest: string): string {
  return `${vertices.map((v) => `v ${v.join(" ")}`).join("\n")}\n${rest}\n`;
}

/** Returns a wavy sheet of n x n squares at height z: its vertices, numbered from `first`, and its triangles. */
export function sheet(n: number, z: number, wave: number, first: number): { vertices: number[][]; faces: string } {
  const vertices: number[][] = [];
  const faces: string[] = [];
  for (let j = 0; j <= n; ++j)
    for (let i = 0; i <= n; ++i) {
      const [x, y] = [i / n, j / n];
      vertices.push([x, y, z + wave * Math.sin(7 * x + 5 * y)]);
      if (i === n || j === n) continue;
      const at = first + j * (n + 1) + i + 1;
      faces.push(`f ${at} ${at + 1} ${at + n + 2}`, `f ${at} ${at + n + 2} ${at + n + 1}`);
    }
  return { vertices, faces: faces.join("\n") };
}

/**
 * The part of a million that tests draw. Drawn in software, a million of anything takes half a minute: scripts/nightly.sh asks
 * for that. Other runs take a sixth, which is more than a function takes arguments.
 */
export const part = process.env.TAMIS_LONG ? 1 : 0.16;
