/**
 * Regression tests on kicks that a team recorded itself: a recording and what is expected of it lie beside the team's tests, and a JUnit test says what has changed.
 *
 * <p>{@link fieldcal.testing.RecordedKicks} marks the test, {@link fieldcal.testing.Recorded} is its parameter. The package is an artifact of its own, {@code fieldcal-testing}, and needs JUnit 5.
 */
@PublicApi
package fieldcal.testing;

import fieldcal.PublicApi;
