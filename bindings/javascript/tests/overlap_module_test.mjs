// SPDX-License-Identifier: Apache-2.0
// The modules of 'vesica/overlap': the whole module's answers to what they have, and an Error for all else.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { circle, ellipse, load, point, rect, segment, VesicaError } from 'vesica';
import { load as loadOverlap } from 'vesica/overlap';

const whole = await load();
const makers = {
  point: (x, y) => point(x, y),
  segment: (x, y, w, h) => segment(x, y, x + w, y - h),
  circle: (x, y, w) => circle(x, y, w),
  rect: (x, y, w, h, angle) => rect(x, y, w, h, angle),
  ellipse: (x, y, w, h, angle) => ellipse(x, y, w, h, angle),
};

let state = 99;
const random = () => (state = (state * 1103515245 + 12345) % 2 ** 31) / 2 ** 31;
// Half of them on a grid, where many touch.
const draw = (make) => make(...Array.from({ length: 5 }, (_, i) => (i < 4 && random() < 0.5 ? Math.ceil(random() * 4) : random() * 4)));

for (const simd of [true, false]) {
  const small = await loadOverlap({ simd });

  test(`${small.isa}: as the whole module`, () => {
    for (const scalar of ['f64', 'f32']) {
      const kinds = Object.entries(makers).map(([kind, make]) => [kind, Array.from({ length: 150 }, () => draw(make))]);
      const [ours, theirs] = [small, whole].map((library) => kinds.map(([kind, list]) => library.shapes(kind, list, { scalar })));
      let overlaps = 0;
      for (let i = 0; i < kinds.length; ++i) {
        for (let j = 0; j < kinds.length; ++j) {
          for (const name of ['overlap', 'interiorsOverlap', 'relation', 'contains', 'overlapMatrix',
            'interiorsOverlapMatrix', 'relationMatrix', 'containsMatrix']) {
            assert.deepEqual(small[name](ours[i], ours[j]), whole[name](theirs[i], theirs[j]), `${name} ${i} ${j}`);
          }
          overlaps += small.overlap(ours[i], ours[j]).reduce((sum, x) => sum + x, 0);
        }
        assert.deepEqual(small.bounds(kinds[i][1][0]), whole.bounds(kinds[i][1][0]));
        assert.deepEqual(small.boundsMany(ours[i]), whole.boundsMany(theirs[i]));
        assert.deepEqual(small.overlapSelect(kinds[0][1][0], ours[i]), whole.overlapSelect(kinds[0][1][0], theirs[i]));
      }
      assert.ok(overlaps > 100 && overlaps < 150 * 25 - 100, `${overlaps} overlaps`);
      const [index, reference] = [small.index(...ours), whole.index(...theirs)];
      for (const query of ['overlap', 'bounds', 'contains', 'interiors']) {
        const pairs = index.join({ query });
        assert.ok(pairs.a.length > 100);
        assert.deepEqual(pairs, reference.join({ query }));
      }
      const many = Array.from({ length: 500 }, () => draw(makers.rect));
      assert.deepEqual(index.join(small.index(small.shapes('rect', many, { scalar }))),
        reference.join(whole.index(whole.shapes('rect', many, { scalar }))));
    }
  });

  test(`${small.isa}: what is wrong or not there`, () => {
    const a = circle(0, 0, 2), b = rect(1, 0, 1, 1, 0.5);
    assert.equal(small.overlap(a, b), true);
    assert.throws(() => small.overlap(circle(0, 0, -1), b), VesicaError);
    for (const name of ['nearest', 'depth', 'area', 'iou', 'boundaryDistance', 'crossings', 'signedDistance', 'de9im']) {
      assert.throws(() => small[name](a, b), /does not have vesica_.*load\(\) of 'vesica'/, name);
    }
    const circles = small.shapes('circle', [a]);
    assert.throws(() => small.iouMatrix(circles, circles), /does not have vesica_iou_matrix_f64/);
    assert.throws(() => small.index(circles).nearest(a, 1), /does not have vesica_index_nearest_f64/);
    assert.throws(() => small.cast(a, b, [1, 0]), /does not have vesica_cast_f64/);
  });
}
