/**
 * The sensors of networks: one small class per sensor, over tables that answer questions about paths without
 * searching.
 */
package mmneat.mspacman.sensors;
