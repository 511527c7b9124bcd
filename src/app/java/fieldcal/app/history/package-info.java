/**
 * What became of the models of a session: {@code history.jsonl} in its folder, one line per model that was published, exported, applied or put back. Written by {@code export} and by the console.
 */
package fieldcal.app.history;
