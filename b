# fanuc/tool-center-point-control 12
N10 G01 F4900 X-40. C-180
N20 G43.4 H0 P0 Z-15.
N30 X-64.148 Y6.47
N40 G42.2 D2 X-72.987 Y21.779
Y-6.903 Z50
N60 X-80.677 Y11.553
N70 X-27.397 Y-41.283
N80 G40 X-27.399 Y-41.284 Z50.002


E 0 L1 N10 t1 c0 p0=-40 p1=0 p2=0 q0=-40 q1=0 q2=0 a0=-40 a1=0 a2=0 a3=0 a4=-180 tool 0 0 1 f4900 u0 al0  [] 0000  0 T0/1 { fanuc.tool-direction.of-pose }
E 0 L2 N20 t1 c0 p0=-40 p1=0 p2=-15 q0=-40 q1=0 q2=-15 a0=-40 a1=0 a2=-61 a3=0 a4=-180 m0=-40 m1=0 m2=-61 m3=0 m4=-180 tool 0 0 1 f4900 u0 al0  [] 0000  0 T0/1 { fanuc.memory.number-zero fanuc.tool-center-point.length fanuc.tool-center-point.control-point-tool-rotation fanuc.tool-center-point.block }
E 0 L3 N30 t1 c0 p0=-64.148 p1=6.47 p2=-15 q0=-64.148 q1=6.47 q2=-15 a0=-64.148 a1=6.47 a2=-61 a3=0 a4=-180 m0=-64.148 m1=6.47 m2=-61 m3=0 m4=-180 tool 0 0 1 f4900 u0 al0  [] 0000  0 T0/1 { fanuc.tool-center-point.length fanuc.tool-center-point.control-point-tool-rotation }
E 2 L4 N40 t1 c0 u0 al57 TOOL_SIDE_MODE [G41.2 or G42.2 under G43.5, or G41.6 or G42.6 without it] 0000  0 T0/1 { fanuc.tool-side.code-for-the-mode }
--
--
fanuc.program.units 5 0 5 0
fanuc.program.least-increments 5 0 5 0
fanuc.program.letters-as-data 4 0 4 0
fanuc.program.incremental 5 0 5 0
fanuc.program.no-feed 4 0 4 0
fanuc.program.end 3 0 3 0
fanuc.memory.number-zero 1 0 0 0
fanuc.tool-center-point.block 1 0 0 0
fanuc.tool-center-point.length 2 0 0 0
fanuc.tool-center-point.without-kinematics 1 0 1 0
fanuc.tool-center-point.programming-system 1 0 1 0
fanuc.tool-center-point.control-point-tool-rotation 2 0 0 0
fanuc.tool-direction.of-pose 1 1 0 0
fanuc.length-offset.ofh 1 0 1 0
fanuc.length-offset.ofh-lone-number 1 0 1 0
fanuc.length-offset.evo 1 0 1 0
fanuc.tool-posture.word 1 0 1 0
fanuc.tool-side.code-for-the-mode 1 0 0 0
--
