/** Champions after evolution: many games under chosen rules, their statistics and reports. */
package mmneat.analysis.evaluation;
