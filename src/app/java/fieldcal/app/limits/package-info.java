/**
 * From recordings to the movement limits of both teams: reads several in parallel ({@link fieldcal.app.limits.LimitsSession}), merges what was counted, and writes {@code limits.json} and
 * {@code limits.html}.
 *
 * <p>Used by the command line. The measuring is {@link fieldcal.movement}'s.
 */
package fieldcal.app.limits;
