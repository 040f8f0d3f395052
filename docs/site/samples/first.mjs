import { circle, load } from 'vesica';

const vesica = await load();
const car = { kind: 'rect', cx: 0, cy: 0, ux: 0.8, uy: 0.6, hx: 2, hy: 1 };
const person = { kind: 'ellipse', cx: 1.5, cy: 1, ux: 1, uy: 0, a: 1, b: 0.5 };
const post = circle(5, 0, 0.5);

const { distance } = vesica.nearest(car, post);
console.log(`overlap ${+vesica.overlap(car, person)}, distance ${distance.toFixed(6)}, IoU ${vesica.iou(car, person).toFixed(6)}`);
