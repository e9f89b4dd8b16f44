//! Values between the rows of a table.

/// The value at `at` on the line through `values` over `axis`, which goes up or down; the end values outside.
pub(super) fn interpolated(axis: &[f64], values: &[f64], at: f64) -> f64 {
    if axis.len() < 2 {
        return values.first().copied().unwrap_or(f64::NAN);
    }
    let goes_up = axis.last() >= axis.first();
    let behind = axis.partition_point(|&place| if goes_up { place <= at } else { place >= at });
    let high = behind.clamp(1, axis.len() - 1);
    let (low, width) = (high - 1, axis[high] - axis[high - 1]);
    let share = if width == 0.0 { 0.0 } else { ((at - axis[low]) / width).clamp(0.0, 1.0) };
    values[low] + share * (values[high] - values[low])
}
