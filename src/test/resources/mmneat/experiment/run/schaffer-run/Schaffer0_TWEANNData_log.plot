set style data lines
set xlabel "Generation"

set title "Schaffer0_TWEANNData Number of Links"
plot \
"Schaffer0_TWEANNData_log.txt" u 1:2 t "MIN", \
"Schaffer0_TWEANNData_log.txt" u 1:3 t "AVG", \
"Schaffer0_TWEANNData_log.txt" u 1:4 t "MAX"

pause -1

set title "Schaffer0_TWEANNData Number of Forward Links"
plot \
"Schaffer0_TWEANNData_log.txt" u 1:6 t "MIN", \
"Schaffer0_TWEANNData_log.txt" u 1:7 t "AVG", \
"Schaffer0_TWEANNData_log.txt" u 1:8 t "MAX"

pause -1

set title "Schaffer0_TWEANNData Number of Recurrent Links"
plot \
"Schaffer0_TWEANNData_log.txt" u 1:10 t "MIN", \
"Schaffer0_TWEANNData_log.txt" u 1:11 t "AVG", \
"Schaffer0_TWEANNData_log.txt" u 1:12 t "MAX"

pause -1

set title "Schaffer0_TWEANNData Number of Neurons"
plot \
"Schaffer0_TWEANNData_log.txt" u 1:14 t "MIN", \
"Schaffer0_TWEANNData_log.txt" u 1:15 t "AVG", \
"Schaffer0_TWEANNData_log.txt" u 1:16 t "MAX"

pause -1

set title "Schaffer0_TWEANNData Number of Modes"
plot \
"Schaffer0_TWEANNData_log.txt" u 1:18 t "MIN", \
"Schaffer0_TWEANNData_log.txt" u 1:19 t "AVG", \
"Schaffer0_TWEANNData_log.txt" u 1:20 t "MAX"

pause -1

set title "Schaffer0_TWEANNData Max Mode Usage"
plot \
"Schaffer0_TWEANNData_log.txt" u 1:22 t "MIN", \
"Schaffer0_TWEANNData_log.txt" u 1:23 t "AVG", \
"Schaffer0_TWEANNData_log.txt" u 1:24 t "MAX"

pause -1

set title "Schaffer0_TWEANNData Min Mode Usage"
plot \
"Schaffer0_TWEANNData_log.txt" u 1:26 t "MIN", \
"Schaffer0_TWEANNData_log.txt" u 1:27 t "AVG", \
"Schaffer0_TWEANNData_log.txt" u 1:28 t "MAX"

pause -1

set title "Schaffer0_TWEANNData Mode 0 Usage"
plot \
"Schaffer0_TWEANNData_log.txt" u 1:30 t "MIN", \
"Schaffer0_TWEANNData_log.txt" u 1:31 t "AVG", \
"Schaffer0_TWEANNData_log.txt" u 1:32 t "MAX"

pause -1

set title "Schaffer0_TWEANNData Mode 1 Usage"
plot \
"Schaffer0_TWEANNData_log.txt" u 1:34 t "MIN", \
"Schaffer0_TWEANNData_log.txt" u 1:35 t "AVG", \
"Schaffer0_TWEANNData_log.txt" u 1:36 t "MAX"

pause -1

set title "Schaffer0_TWEANNData Mode 2 Usage"
plot \
"Schaffer0_TWEANNData_log.txt" u 1:38 t "MIN", \
"Schaffer0_TWEANNData_log.txt" u 1:39 t "AVG", \
"Schaffer0_TWEANNData_log.txt" u 1:40 t "MAX"

pause -1

set title "Schaffer0_TWEANNData Mode 3 Usage"
plot \
"Schaffer0_TWEANNData_log.txt" u 1:42 t "MIN", \
"Schaffer0_TWEANNData_log.txt" u 1:43 t "AVG", \
"Schaffer0_TWEANNData_log.txt" u 1:44 t "MAX"

pause -1

set title "Schaffer0_TWEANNData Archetype Nodes"
plot \
"Schaffer0_TWEANNData_log.txt" u 1:46 t "MIN", \
"Schaffer0_TWEANNData_log.txt" u 1:47 t "AVG", \
"Schaffer0_TWEANNData_log.txt" u 1:48 t "MAX"

pause -1

set title "Schaffer0_TWEANNData Constant Usage"
plot \
"Schaffer0_TWEANNData_log.txt" u 1:50 t "MIN", \
"Schaffer0_TWEANNData_log.txt" u 1:51 t "AVG", \
"Schaffer0_TWEANNData_log.txt" u 1:52 t "MAX"

pause -1

