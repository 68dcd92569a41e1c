extends Node
func build(_s, _t): pass
func robot_at(_a, _m, _f): pass
