#lang racket/base
;; The names that a program gives to its arguments, read off its definitions:
;;
;;     (define ((L-pendulum g m l) (up t theta thetadot)) ...)
;;
;; names parameters and coordinates, which are mere numbers when the program runs.

(require racket/list
         racket/path
         racket/runtime-path
         "../program-file.rkt" "../redefinition/heads.rkt"
         "../../generic/up-down.rkt"
         (only-in "../../value/shape.rkt" shape-length)
         (only-in "../../value/structure.rkt" structure->list))

(provide program-heads book-heads defined-names
         parameter-names state-names pattern-state)

;; stx : of a module -> hasheq, name -> list of lists of arguments, the outermost first
(define (program-heads stx)
  (let walk ([x (syntax->datum stx)] [heads (hasheq)])
    (cond [(definition? x) (walk (cddr x) (with-head (cadr x) heads))]
          [(pair? x) (walk (cdr x) (walk (car x) heads))]
          [else heads])))

(define (definition? x)
  (and (pair? x) (eq? 'define (car x)) (pair? (cdr x)) (pair? (cadr x))))

;; The first definition of a name counts.
(define (with-head head heads)
  (let peel ([head head] [arguments '()])
    (cond [(pair? head) (peel (car head) (cons (cdr head) arguments))]
          [(and (symbol? head) (not (hash-has-key? heads head))) (hash-set heads head arguments)]
          [else heads])))

;; stx : of a module -> the names that its own forms define, procedures or not
(define (defined-names stx)
  (let walk ([x (syntax->datum stx)])
    (define forms (if (list? x) x '()))
    (append*
     (for/list ([form (in-list forms)] #:when (pair? form))
       (case (car form)
         [(define) (if (pair? (cdr form)) (list (head-name-in (cadr form))) '())]
         [(#%module-begin #%plain-module-begin begin) (walk form)]
         [else '()])))))

(define-runtime-path book-folder "../../book")
(define-runtime-path rigid-folder "../../rigid")

;; The heads of the book's objects and of rigid bodies, as far as their programs are installed.
(define (book-heads)
  (for*/fold ([heads (hasheq)]) ([folder (in-list (list rigid-folder book-folder))]
                                 [file (in-list (directory-list folder #:build? #t))]
                                 #:when (path-has-extension? file #".rkt"))
    (define stx (call-with-program file (lambda (port) (read-program file port))))
    (for/fold ([heads heads]) ([(name arguments) (in-hash (program-heads stx))])
      (hash-set heads name arguments))))

;; ---------------------------------------------------------------------------

;; The names of the parameters, if there are so many; or #f
(define (parameter-names heads name count)
  (define parameters (argument-list heads name car))
  (and (list? parameters) (= count (length parameters)) (andmap symbol? parameters) parameters))

;; pick : of the lists of arguments that the name takes; #f without any
(define (argument-list heads name pick)
  (define arguments (hash-ref heads name '()))
  (and (pair? arguments) (pick arguments)))

;; A state of zeros, of the shape of the last argument of the name; or #f
(define (pattern-state heads name)
  (define pattern (last-pattern heads name))
  (and pattern (pattern->zeros pattern)))

(define (pattern->zeros p)
  (if (pair? p)
      (apply (if (eq? 'down (car p)) down up) (map pattern->zeros (cdr p)))
      0))

;; (up ...), if the last procedure of the head takes that alone; or #f
(define (last-pattern heads name)
  (define formals (argument-list heads name last))
  (and (list? formals) (= 1 (length formals)) (pattern? (car formals)) (car formals)))

(define (pattern? x) (and (list? x) (pair? x) (memq (car x) '(up down)) #t))

;; The names of a state's scalars, #f for a scalar without a name; or #f if the last argument of
;; the name is no pattern of the state
(define (state-names heads name example)
  (define pattern (last-pattern heads name))
  (and pattern (tuple? example)
       (let/ec return (names-within pattern example (lambda () (return #f))))))

(define (names-within pattern x fail)
  (cond [(and (tuple? x) (pattern? pattern))
         (define parts (structure->list x))
         (unless (= (length parts) (length (cdr pattern))) (fail))
         (append* (for/list ([p (in-list (cdr pattern))] [e (in-list parts)])
                    (names-within p e fail)))]
        [(tuple? x) (if (symbol? pattern) (numbered pattern x) (fail))]
        [(and (symbol? pattern) (not (eq? pattern '_))) (list pattern)]
        [else (list #f)]))

(define (numbered name x)
  (for/list ([k (in-range (shape-length x))])
    (and (not (eq? name '_)) (string->symbol (format "~a~a" name k)))))
