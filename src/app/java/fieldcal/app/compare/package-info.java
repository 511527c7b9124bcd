/** What a simulator gets wrong: the recordings of a field against those of a simulator, and what the differences cost an AI that was tuned on the simulator. {@code compare} without the command line. */
package fieldcal.app.compare;
