/**
 * The answers of the library in an operator's words: what is wrong, what it does to the game, what to do about it.
 *
 * <p>{@link fieldcal.app.wording.CauseWords} puts each cause of a diagnosis into sentences, {@link fieldcal.app.wording.VerdictText} the whole of it. Plain
 * text without markup, so that the terminal and the report say the same. Used by the command line and the report; depends on the library only.
 */
package fieldcal.app.wording;
