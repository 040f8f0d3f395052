use vesica::{iou, nearest, overlap, rect, Circle, Ellipse};

fn main() -> Result<(), vesica::Error> {
    let car = rect(0.0_f64, 0.0, 36.87_f64.to_radians(), 4.0, 2.0)?; // x, y, angle, width, height
    let person = Ellipse { cx: 1.5, cy: 1.0, ux: 1.0, uy: 0.0, a: 1.0, b: 0.5 }; // centre, axis, half axes
    let post = Circle { cx: 5.0, cy: 0.0, r: 0.5 };

    let hit = overlap(&car, &person)? as i32;
    let (gap, share) = (nearest(&car, &post)?.distance, iou(&car, &person)?);
    println!("overlap {hit}, distance {gap:.3}, IoU {share:.3}");
    Ok(())
}
