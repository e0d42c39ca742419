import { load } from "tamis";

const tamis = await load();
// a plate, and a blade that turns a quarter about y: its tip goes down to the plate
const plate = tamis.shape({ faces: [0, 1, 2] }, [-5, -5, 0, 5, -5, 0, 0, 5, 0]);
const blade = tamis.shape({ faces: [0, 1, 2] }, [0, 0, 0, 2, 0, 0, 1, 0.5, 0]);
const world = tamis.world();
world.add(plate);
const way = tamis.interpolatedChain([0, 0, 1, 0, 0, 0], [0, 0, 1, 0, Math.PI / 2, 0]);
const turning = world.add(blade, { links: way });
for (const { bodies, toiLower } of world.firstContacts())
  console.log(`bodies ${bodies[0]} and ${bodies[1]} touch at ${toiLower.toFixed(6)}`);
// every pair keeps a tenth of its distance: the blade goes so far, and stays there
const { toiLower } = world.safeStep(0.1);
world.move(turning, { poses: tamis.poseAt(way, toiLower) });
console.log(`it may go ${toiLower.toFixed(4)} of its way`);
for (const each of [world, plate, blade]) each.free();
