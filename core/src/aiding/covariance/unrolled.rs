//! Loops over parts of columns, four elements at a time: their length changes from column to column, so that a compiler
//! leaves them rolled up. The order of operations is that of the plain loop.

/// A function of each pair of elements.
#[inline(always)]
pub(super) fn pairs<A, B>(a: &mut [A], b: &mut [B], mut f: impl FnMut(&mut A, &mut B)) {
    let (a, b) = shortened(a, b);
    let ((fours, rest), (other_fours, other_rest)) =
        (a.as_chunks_mut::<4>(), b.as_chunks_mut::<4>());
    for (a, b) in fours.iter_mut().zip(other_fours) {
        for (a, b) in a.iter_mut().zip(b) {
            f(a, b);
        }
    }
    for (a, b) in rest.iter_mut().zip(other_rest) {
        f(a, b);
    }
}

/// The first elements of both, as many as the shorter one has.
#[inline(always)]
fn shortened<'a, A, B>(a: &'a mut [A], b: &'a mut [B]) -> (&'a mut [A], &'a mut [B]) {
    let count = a.len().min(b.len());
    (
        a.split_at_mut_checked(count).map_or(&mut [], |(a, _)| a),
        b.split_at_mut_checked(count).map_or(&mut [], |(b, _)| b),
    )
}

/// A sum over pairs of elements, first to last.
#[inline(always)]
pub(super) fn sum<A, B, S>(start: S, a: &[A], b: &[B], mut f: impl FnMut(S, &A, &B) -> S) -> S {
    let count = a.len().min(b.len());
    let (a, b) = (a.get(..count).unwrap_or(&[]), b.get(..count).unwrap_or(&[]));
    let ((fours, rest), (other_fours, other_rest)) = (a.as_chunks::<4>(), b.as_chunks::<4>());
    let mut sum = start;
    for (a, b) in fours.iter().zip(other_fours) {
        for (a, b) in a.iter().zip(b) {
            sum = f(sum, a, b);
        }
    }
    for (a, b) in rest.iter().zip(other_rest) {
        sum = f(sum, a, b);
    }
    sum
}
