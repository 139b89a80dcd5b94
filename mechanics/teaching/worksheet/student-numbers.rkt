#lang racket/base
;; Numbers that differ from student to student: each is chosen by a hash of the worksheet's seed,
;; the student's name and the number's name, so that it is the same on all machines.

(require (only-in racket/list check-duplicates)
         (only-in racket/string string-join)
         "exercise.rkt"
         "../../error/complain.rkt"
         "../../generic/describe.rkt")

(provide current-student student-number stepped make-numbers call-for-student)

;; The name of the student whose worksheet is made, or #f: then the first of the values is taken.
(define current-student (make-parameter #f))

(define (student-number name seed choices)
  (when (null? choices)
    (complain 'parameters "~a has no value, as in [~a 1 2 3]" name name))
  (for ([x (in-list choices)] #:unless (real? x))
    (complain 'parameters "the values of ~a are numbers\n  given: ~a" name (value->text x)))
  (define student (current-student))
  (define x (list-ref choices (if student (choice (length choices) seed student name) 0)))
  (define all (current-numbers))
  (when all (set-box! all (cons (format "~a = ~a" name (value->text x)) (unbox all))))
  x)

;; -> 0 ... n - 1
(define (choice n seed student name)
  (define plain (string-foldcase (string-normalize-nfc student)))
  (define hash (sha256-bytes (string->bytes/utf-8 (format "~a\n~a\n~a" seed plain name))))
  (modulo (integer-bytes->integer hash #f #t 0 8) n))

;; from, from + step, ..., up to `to`
(define (stepped name from to step)
  (unless (and (real? from) (real? to) (real? step) (> step 0) (<= from to))
    (complain 'parameters "~a goes up in steps, as in [~a #:from 1 #:to 3 #:step 1/2]" name name))
  (define-values (a b d) (apply values (map written (list from to step))))
  (define (as-given x) (if (andmap exact? (list from to step)) x (exact->inexact x)))
  (for/list ([k (in-range (+ 1 (floor (/ (- b a) d))))]) (as-given (+ a (* k d)))))

;; The decimals that are written: 0.1 is 1/10.
(define (written x) (if (exact? x) x (string->number (format "~a" x) 10 'read 'decimal-as-exact)))

;; A box of the numbers of a worksheet that is being made, as texts; or #f
(define current-numbers (make-parameter #f))

;; (make) -> the worksheet of a student; an error in it tells the student and the numbers
(define (call-for-student student make)
  (define chosen (box '()))
  (define (raise-with-numbers x)
    (complain 'worksheet "the worksheet of ~a cannot be made\n  numbers: ~a\n  ~a" student
              (string-join (reverse (unbox chosen)) ", ") (exn-message x)))
  (parameterize ([current-student student] [current-numbers chosen])
    (with-handlers ([exn:fail? raise-with-numbers]) (make))))

;; -> part of a worksheet: their definitions
(define (make-numbers names values)
  (define twice (check-duplicates names))
  (when twice (complain 'parameters "~a stands there twice" twice))
  (define student (current-student))
  (numbers (string-join
            (append (if student (list (format ";; The numbers of ~a" student)) '())
                    (for/list ([n (in-list names)] [x (in-list values)])
                      (format "(define ~a ~a)" n x)))
            "\n")
           student))
