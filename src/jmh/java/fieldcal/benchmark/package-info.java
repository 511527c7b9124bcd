/**
 * {@code ./gradlew benchmark}: accuracy and speed, measured and put beside their goals.
 *
 * <p>{@link fieldcal.benchmark.Benchmarks} picks by name; what needs a package's inside, such as the fit's Cramér–Rao bound, lies
 * with that package in this source set. Micro benchmarks are JMH's ({@code ./gradlew jmh}).
 */
package fieldcal.benchmark;
