/**
 * {@code archive} without its engine: what is asked for, what came out, and how the command finds the engine. The engine is {@code fieldcal.archive} in {@code
 * src/archive}, which brings Apache Spark and so has a class path of its own.
 */
package fieldcal.app.archive;
