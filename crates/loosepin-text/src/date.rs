//! Dates as text, in UTC.

use std::time::{SystemTime, UNIX_EPOCH};

/// 1 January of the year 10000: from there on a date has no form in RFC 3339.
const YEAR_10000_S: u64 = 253_402_300_800;

/// `2026-11-25T17:00:15Z` (RFC 3339); `None` if the clock is before 1970 or after 9999.
pub fn date(time: SystemTime) -> Option<String> {
    let since_1970 = time.duration_since(UNIX_EPOCH).ok()?;
    (since_1970.as_secs() < YEAR_10000_S).then(|| humantime::format_rfc3339_seconds(time).to_string())
}

/// `2026-11-25 17:00 UTC`; `None` if [`date`] gives nothing.
pub fn date_for_reading(time: SystemTime) -> Option<String> {
    let date = date(time)?;
    let (day, clock) = date.split_once('T')?;
    Some(format!("{day} {} UTC", clock.get(..5)?))
}

#[cfg(test)]
mod tests {
    use super::{YEAR_10000_S, date, date_for_reading};
    use std::time::{Duration, UNIX_EPOCH};

    #[test]
    fn a_clock_outside_of_the_calendar_gives_no_date() {
        let day = Duration::from_secs(86_400);
        assert_eq!(date(UNIX_EPOCH + day).as_deref(), Some("1970-01-02T00:00:00Z"));
        assert_eq!(date(UNIX_EPOCH - day), None);
        assert_eq!(date(UNIX_EPOCH + Duration::from_secs(YEAR_10000_S - 1)).as_deref(), Some("9999-12-31T23:59:59Z"));
        assert_eq!(date(UNIX_EPOCH + Duration::from_secs(YEAR_10000_S)), None);
        assert_eq!(date_for_reading(UNIX_EPOCH - day), None);
    }

    #[test]
    fn a_date_is_read_to_the_minute() {
        let noon = UNIX_EPOCH + Duration::from_secs(12 * 3600 + 34 * 60 + 56);
        assert_eq!(date_for_reading(noon).as_deref(), Some("1970-01-01 12:34 UTC"));
    }
}
