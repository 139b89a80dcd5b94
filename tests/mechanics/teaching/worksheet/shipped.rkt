#lang racket/base
;; The worksheets that are shipped, each exercise tried with five answers: the right one, an
;; equivalent one, two that are wrong, and none.  The kind of an exercise decides which answers
;; are equivalent and which are wrong.

(require (prefix-in m: mechanics)
         mechanics/teaching/worksheet/exercise
         mechanics/teaching/worksheet/judge
         mechanics/teaching/worksheet/judgment
         mechanics/teaching/worksheet/prescribed-symbols
         mechanics/teaching/worksheet/student-file
         (only-in racket/file file->string)
         (only-in racket/list count)
         racket/runtime-path
         "../../support/checks.rkt")

(define-runtime-path folder "../../../../examples/mechanics/worksheets")

(define-namespace-anchor here)
(define (load path)
  (parameterize ([current-namespace (namespace-anchor->empty-namespace here)])
    (dynamic-require path 'worksheet)))

(define files
  (for/list ([name (in-list (directory-list folder))]
             #:when (regexp-match? #rx"[.]rkt$" (path->string name)))
    (build-path folder name)))

(define worksheets (map load files))

;; As its second line says.
(define (chapter file)
  (define m (regexp-match #rx"^[^\n]*\n;; SICM ([0-9])[.]" (file->string file)))
  (string->number (cadr m)))

(test-case "there are ten of chapter 1, and one for each later chapter at least"
  (define chapters (map chapter files))
  (define (of n) (count (lambda (c) (= c n)) chapters))
  (check-true (>= (of 1) 10))
  (for ([n (in-range 2 8)]) (check-true (>= (of n) 1) (format "chapter ~a" n))))

;; ---------------------------------------------------------------------------
;; Answers made of the key, by kind -> expressions

(define (each f x) (m:s:map/r f x))
(define one (m:+ (m:square (m:sin 's)) (m:square (m:cos 's))))

(define (as-equivalent e key)
  (define names (exercise-coordinates e))
  (define local (and (pair? names) (local-tuple-of names)))
  (case (exercise-kind e)
    [(Lagrangian)                       ; another factor, and a total time derivative
     (define q (car names))
     (m:+ (m:* 2 key) (m:* q (car (m:vector->list (m:up (velocity-of names))))))]
    [(equations) (each (lambda (x) (m:* 'm 3 x)) key)]
    [(conserved) (m:+ 7 (m:* 2 key))]
    [(number) (m:* key 1.0001)]
    [(canonical) key]
    [(Hamiltonian) (m:+ key (m:sin 't))]
    [else (each (lambda (x) (m:* one x)) key)]))

(define (velocity-of names)
  (define v (m:ref (local-tuple-of names) 2))
  (if (null? (cdr names)) v (m:ref v 0)))

;; A sign, and a factor.
(define (as-wrong e key)
  (define names (exercise-coordinates e))
  (case (exercise-kind e)
    [(Lagrangian) (list (m:+ key (m:* 'c (m:square (velocity-of names)) (car names)))
                        (m:+ key (m:* 'c (m:cube (car names)))))]
    [(equations)
     (define q ((m:literal-function (car names)) 't))
     (list (each (lambda (x) (m:- x (m:* 'c q))) key)
           (each (lambda (x) (m:+ x (m:* 'c (m:cube q)))) key))]
    [(conserved) (list (m:+ key (m:* 'c (car names))) (m:* key 't))]
    [(solution) (list (each (lambda (x) (m:+ x (m:exp 't))) key)
                      (each (lambda (x) (m:+ x (m:cube 't))) key))]
    [(canonical) (list (m:up 't (m:* 2 (m:ref key 1)) (m:ref key 2))
                       (m:up 't (m:ref key 1) (m:- (m:ref key 2))))]
    [else (list (each m:- key) (each (lambda (x) (m:* 2 x)) key))]))

;; ---------------------------------------------------------------------------

(define (judge-value e x) (judge e (list 'answer (m:expression x))))

(define (check-exercise e)
  (define name (symbol->string (exercise-name e)))
  (define key (and (exercise-key e) (m:read-expression (exercise-key e))))
  (define (status x) (judgment-status (judge-value e x)))
  (check-equal? (judgment-status (judge e '(unanswered))) 'unanswered name)
  (when key
    (check-equal? (status key) 'right name)
    (check-equal? (status (as-equivalent e key)) 'right name)
    (for ([x (in-list (as-wrong e key))])
      (define j (judge-value e x))
      (check-not-false (memq (judgment-status j) '(wrong partly)) (format "~a: ~a" name x))
      (check-true (< (judgment-share j) 1) name))))

(for ([w (in-list worksheets)])
  (test-case (worksheet-title w)
    (for-each check-exercise (exercises-of w))
    (for* ([e (in-list (exercises-of w))] [s (in-list (exercise-slips e))])
      (define j (judge e (list 'answer (slip-datum s))))
      (check-equal? (car (judgment-words j)) (slip-message s)))
    (check-regexp-match #rx"^#lang mechanics\n" (worksheet->student-file w))))
