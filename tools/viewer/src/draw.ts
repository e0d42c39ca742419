// Updates the drawing when the state changes.
import type { Actions } from "./actions";
import { advance } from "./player";
import { kFilterKeys, type Session } from "./session";
import { colourOfTime } from "./colours";
import { thinned } from "./view3d/large";
import { emptySegments, type SegmentData } from "./view3d/segments";
import type { Stage } from "./view3d/stage";

/** The colours of times of impact as the shader computes with them, four bytes each, in 256 steps. */
const kColours = new Uint32Array(
  Uint8Array.from({ length: 4 * 256 }, (_, i) => {
    const colour = [...colourOfTime(Math.floor(i / 4) / 255), 255][i % 4];
    return i % 4 === 3 ? 255 : Math.round(255 * (colour / 255) ** 2.2);
  }).buffer,
);

const colourAt = (time: number): number => kColours[Math.round(255 * Math.min(Math.max(time, 0), 1))];

/** Normals and features are drawn of at most so many contacts. */
const kMostFigures = 20_000;

const figuresOf = ({ drawn }: Session): Uint32Array => thinned(drawn, 1, kMostFigures);

/** Segments along the normals of contacts, a fiftieth of the scene long. */
function normalsOf(session: Session): SegmentData {
  const { scene, view } = session;
  const rows = figuresOf(session);
  const { contacts } = scene;
  const { start, end } = view.marks;
  const data = emptySegments(rows.length);
  const colours = new Uint32Array(data.colour.buffer);
  rows.forEach((i, k) => {
    const place = 3 * (i - view.step.first);
    const normal = scene.direction(contacts.normal(i));
    for (let axis = 0; axis < 3; ++axis) {
      data.fromStart[3 * k + axis] = start[place + axis];
      data.fromEnd[3 * k + axis] = end[place + axis];
      data.toStart[3 * k + axis] = start[place + axis] + 0.04 * normal[axis];
      data.toEnd[3 * k + axis] = end[place + axis] + 0.04 * normal[axis];
    }
    colours[k] = colourAt(contacts.toiLower[i]);
  });
  return data;
}

/** The number of edges of a feature with so many vertices. */
const edgesIn = (vertices: number): number => (vertices === 3 ? 3 : vertices - 1);

/** The edges of contacts' features. */
function featuresOf(session: Session): SegmentData {
  const { scene, view } = session;
  const rows = figuresOf(session);
  const { contacts } = scene;
  const { start, end } = view.step;
  let count = 0;
  for (const i of rows) count += edgesIn(contacts.kindOf(i).first) + edgesIn(contacts.kindOf(i).second);
  const data = emptySegments(count);
  const { fromStart, fromEnd, toStart, toEnd } = data;
  const colours = new Uint32Array(data.colour.buffer);
  let place = 0;
  const join = (i: number, from: number, size: number, colour: number): void => {
    for (let k = 0; k < edgesIn(size); ++k) {
      const a = 3 * contacts.vertex(i, from + k);
      const b = 3 * contacts.vertex(i, from + ((k + 1) % size));
      for (let axis = 0; axis < 3; ++axis) {
        fromStart[3 * place + axis] = start[a + axis];
        fromEnd[3 * place + axis] = end[a + axis];
        toStart[3 * place + axis] = start[b + axis];
        toEnd[3 * place + axis] = end[b + axis];
      }
      colours[place++] = colour;
    }
  };
  for (const i of rows) {
    const { first, second } = contacts.kindOf(i);
    const colour = colourAt(contacts.toiLower[i]);
    join(i, 0, first, colour);
    join(i, first, second, colour);
  }
  return data;
}

export function draw(session: Session, stage: Stage, actions: Actions): void {
  const { store } = session;
  store.follow(["step", "up"], () => {
    stage.showStep(session.view.step, session.view.firstTouch);
    stage.showMarks(session.view.marks);
  });
  store.follow(kFilterKeys, () => {
    const { first } = session.view.step;
    stage.chooseMarks(session.drawn.map((contact) => contact - first));
  });
  store.follow([...kFilterKeys, "normals"], () => {
    stage.showNormals(store.now.normals ? normalsOf(session) : null);
  });
  store.follow([...kFilterKeys, "features"], () => {
    stage.showFeatures(store.now.features ? featuresOf(session) : null);
  });
  store.follow(["step", "up", "selected", "isolated", "theme"], () => {
    stage.showPair(session.pair, store.now.isolated, store.now.theme);
  });
  store.follow(["step", "up", "selected", "isolated"], () => {
    if (session.pair && store.now.isolated) actions.flyTo(session.pair);
  });
  store.follow(["time", "step", "up", "selected", "isolated", "theme"], () => {
    stage.setTime(store.now.time);
  });
  store.follow(["brush"], () => {
    stage.brush = store.now.brush;
  });
  store.follow(["theme"], () => {
    stage.theme = store.now.theme;
  });
  store.follow(["smooth"], () => {
    stage.surface.smooth = store.now.smooth;
    stage.request();
  });
  store.follow(["edges"], () => {
    stage.surface.showEdges(store.now.edges);
    stage.request();
  });
  store.follow(["marks", "xray"], () => {
    stage.setVisible(store.now.marks, store.now.xray);
  });
  store.follow(["playing"], () => {
    stage.request();
  });
  stage.beforeFrame = (seconds) => advance(session, seconds);
}
