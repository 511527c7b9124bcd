/**
 * Watching a match, live or recorded: where frames come from ({@link fieldcal.app.monitor.ReplayFeed}, {@link fieldcal.app.monitor.NetworkFeed}), what the operator sees, the file of changes and the state that
 * pools matches. {@link fieldcal.live.LiveMonitor} does the work.
 */
package fieldcal.app.monitor;
