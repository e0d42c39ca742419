// Updates the drawing when the state changes.
import type { Actions } from "./actions";
import { advance } from "./player";
import { kFilterKeys, type Session } from "./session";
import type { Vec3 } from "./vectors";
import { add, times } from "./vectors";
import { colourOfTime } from "./colours";
import { emptySegments, segmentsBetween, type SegmentData } from "./view3d/segments";
import type { Stage } from "./view3d/stage";

const linear = (time: number): number[] => [...colourOfTime(time).map((c) => Math.round(255 * (c / 255) ** 2.2)), 255];

/** Segments along the normals of the listed contacts, a fiftieth of the scene long. */
function normalsOf({ scene, view, rows }: Session): SegmentData {
  const { contacts } = scene;
  const { start, end } = view.marks;
  const data = emptySegments(rows.length);
  rows.forEach((i, k) => {
    const place = 3 * (i - view.step.first);
    const normal = scene.direction(contacts.normal(i));
    const tip = (at: Float32Array): Vec3 => add([at[place], at[place + 1], at[place + 2]], times(0.04, normal));
    data.fromStart.set(start.subarray(place, place + 3), 3 * k);
    data.fromEnd.set(end.subarray(place, place + 3), 3 * k);
    data.toStart.set(tip(start), 3 * k);
    data.toEnd.set(tip(end), 3 * k);
    data.colour.set(linear(contacts.toiLower[i]), 4 * k);
  });
  return data;
}

/** The edges of all listed contacts' features. */
function featuresOf({ scene, view, rows }: Session): SegmentData {
  const { contacts } = scene;
  const pairs: number[] = [];
  const owners: number[] = [];
  const join = (feature: number[], owner: number): void => {
    for (let k = 0; k < (feature.length === 3 ? 3 : feature.length - 1); ++k) {
      pairs.push(feature[k], feature[(k + 1) % feature.length]);
      owners.push(owner);
    }
  };
  for (const i of rows) {
    join(contacts.firstFeature(i), i);
    join(contacts.secondFeature(i), i);
  }
  return segmentsBetween(pairs, view.step.start, view.step.end, (p) => linear(contacts.toiLower[owners[p]]));
}

export function draw(session: Session, stage: Stage, actions: Actions): void {
  const { store } = session;
  store.follow(["step", "up"], () => {
    stage.showStep(session.view.step, session.view.firstTouch);
    stage.showMarks(session.view.marks);
  });
  store.follow(kFilterKeys, () => {
    stage.marksChanged();
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
