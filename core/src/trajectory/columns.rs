//! The quaternion of axes that change with time.

use super::series::Series;
use crate::math::quaternion::Quaternion;
use crate::math::vector::Vector;

/// The unit quaternion of a rotation matrix by its columns: the largest component by a root, the others by
/// quotients with it. Source: Shepperd, Journal of Guidance and Control 1(3), 1978.
pub(super) fn quaternion<const M: usize>(
    x: Vector<Series<M>>,
    y: Vector<Series<M>>,
    z: Vector<Series<M>>,
) -> Quaternion<Series<M>> {
    let (a, b, c) = (x.x.value(), y.y.value(), z.z.value());
    let q = if a + b + c > 0.0 {
        let w = (x.x + y.y + z.z).plus(1.0);
        Quaternion::new(w, Vector::new(y.z - z.y, z.x - x.z, x.y - y.x))
    } else if a > b && a > c {
        let first = (x.x - y.y - z.z).plus(1.0);
        Quaternion::new(y.z - z.y, Vector::new(first, x.y + y.x, z.x + x.z))
    } else if b > c {
        let second = (y.y - x.x - z.z).plus(1.0);
        Quaternion::new(z.x - x.z, Vector::new(x.y + y.x, second, y.z + z.y))
    } else {
        let third = (z.z - x.x - y.y).plus(1.0);
        Quaternion::new(x.y - y.x, Vector::new(z.x + x.z, y.z + z.y, third))
    };
    q * (q.w * q.w + q.v.dot(q.v)).reciprocal_root()
}
