# SPDX-License-Identifier: MIT
## The base of all tests: how it prints a failure, and that a test without a check fails.
extends "res://tests/case.gd"

const Case := preload("res://tests/case.gd")
const FEW_LINES := 800  # characters

var judged: Case


func before() -> void:
	judged = Case.new()


func after() -> void:
	judged.free()


func test_a_failure_of_long_values_is_a_few_lines() -> void:
	var zeros := PackedVector3Array()
	zeros.resize(1024)
	var other := zeros.duplicate()
	other[700].y = 2.0
	var words := "word ".repeat(20_000)
	judged.assert_eq(other, zeros)
	judged.assert_eq(zeros.slice(1), zeros)
	judged.assert_eq(words, words + "end")
	judged.assert_ne(words, words)
	judged.assert_less(words, words, words)
	judged.fail(words)
	judged.assert_eq([words], [1])
	judged.judge([{text = words, where = "somewhere", warning = false}])
	assert_eq(judged.failures.size(), 8)
	for failure in judged.failures:
		assert_less(failure.length(), FEW_LINES, failure.left(FEW_LINES))
	assert_true(judged.failures[0].contains("element 700 of 1024: expected (0.0, 0.0, 0.0), got (0.0, 2.0, 0.0)"), judged.failures[0])
	assert_true(judged.failures[1].contains("expected 1024 elements, got 1023"), judged.failures[1])


func test_a_short_failure_says_all() -> void:
	judged.assert_eq([1, 2], [1, 3], "numbers")
	assert_true(judged.failures[0].ends_with("expected [1, 3], got [1, 2] (numbers)"), judged.failures[0])


func test_many_failures_of_a_test_are_counted() -> void:
	for i in 1000:
		judged.assert_true(false, "round %d" % i)
	assert_eq(judged.failures.size(), 1000)
	assert_less(judged.summary().length(), 5 * FEW_LINES)
	assert_true(judged.summary().ends_with("and 995 more"), judged.summary())


func test_a_test_without_a_check_fails() -> void:
	judged.judge([])
	assert_eq(judged.failures.size(), 1)
	assert_true(judged.failures[0].ends_with("the test checks nothing"), judged.failures[0])


func test_one_check_or_a_skip_is_enough() -> void:
	judged.assert_true(true)
	judged.judge([])
	assert_eq(judged.failures, [] as Array[String])
	judged.checks = 0
	judged.skip("no GPU")
	judged.judge([])
	assert_eq(judged.failures, [] as Array[String])
