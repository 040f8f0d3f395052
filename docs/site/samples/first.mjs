import { circle, ellipse, load, rect } from 'vesica';

const vesica = await load();
const car = rect(0, 0, 4, 2, 36.87, { degrees: true }); // x, y, width, height, angle
const person = ellipse(1.5, 1, 1, 0.5); // x, y, half axes
const post = circle(5, 0, 0.5);

const { distance } = vesica.nearest(car, post);
const iou = vesica.iou(car, person);
console.log(`overlap ${+vesica.overlap(car, person)}, distance ${distance.toFixed(3)}, IoU ${iou.toFixed(3)}`);
